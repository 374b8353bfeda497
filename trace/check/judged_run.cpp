#include "check/judged_run.h"

#include "check/decision_of.h"

namespace vidno {

namespace {

/// Compares the decisions of an always right kernel with those of `exact`, in order, until they diverge.
template <class Taken>
class Comparison {
public:
    explicit Comparison(const std::vector<Taken>& right) : right_(right) {}

    Verdict verdict(Decision of, const Taken& taken, auto&& as_answer) {
        Verdict verdict{of, as_answer(taken), {}};
        if (!parted_ && next_ < right_.size()) verdict.truth.answer = as_answer(right_[next_++]);
        parted_ = parted_ || verdict.wrong();
        verdict.right_for_operands = !verdict.wrong();
        return verdict;
    }

private:
    const std::vector<Taken>& right_;
    std::size_t next_ = 0;
    bool parted_ = false;
};

RunRequest exactly(const RunRequest& request, EventSink& sink) {
    RunRequest exact = request;
    exact.kernel = kernel_of(KernelKind::exact);
    exact.sink = &sink;
    exact.regions = nullptr;
    return exact;
}

/// Compares the decisions that events report.
Picture compared_run(const RunRequest& request, const Followers& followers) {
    std::vector<Answer> right;
    HeardBy keep([&](const EventView& event) {
        if (const auto taken = decision_of(event)) right.push_back(taken->answer);
    });
    told_run(exactly(request, keep));
    Comparison<Answer> comparison(right);
    HeardBy compare([&](const EventView& event) {
        if (const auto taken = decision_of(event)) {
            (*followers.judge)(comparison.verdict(taken->of, taken->answer, std::identity{}));
        }
        request.sink->hear(event);
    });
    RunRequest compared = request;
    compared.sink = &compare;
    return told_run(compared, {.count = followers.count});
}

/// Compares signs, since Weiler and Atherton's algorithm takes more decisions than its events report.
Picture compared_weiler_atherton(const RunRequest& request, const Followers& followers) {
    std::vector<Sign> right;
    const HearSign keep = [&](Sign sign) { right.push_back(sign); };
    HeardBy nobody([](const EventView&) {});
    RunRequest exact = exactly(request, nobody);
    exact.detail = Detail::windows;
    told_run(exact, {.hear_sign = &keep});
    Comparison<Sign> comparison(right);
    const HearSign compare = [&](Sign sign) {
        const auto as_answer = [](Sign of) { return Answer(int(of)); };
        (*followers.judge)(comparison.verdict(Decision::comparison, sign, as_answer));
    };
    return told_run(request, {.count = followers.count, .hear_sign = &compare});
}

}  // namespace

Picture exactly_judged_run(const RunRequest& request, const Followers& followers) {
    return told_run(exactly(request, *request.sink), followers);
}

Picture judged_run(const RunRequest& request, const Followers& followers) {
    if (!request.kernel.is_always_right()) return told_run(request, followers);
    switch (algorithm_of(request.method)) {
        case Algorithm::warnock:
        case Algorithm::z_buffer: return compared_run(request, followers);
        case Algorithm::weiler_atherton: return compared_weiler_atherton(request, followers);
    }
    std::abort();
}

}  // namespace vidno
