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

bool is_of_regions(const RunRequest& request) { return algorithm_of(request.method) == Algorithm::weiler_atherton; }

RunRequest exactly(const RunRequest& request, EventSink& sink) {
    RunRequest exact = request;
    exact.kernel = kernel_of(KernelKind::exact);
    exact.sink = &sink;
    exact.regions = nullptr;
    return exact;
}

Picture compared_by_answers(const RunRequest& request, const std::vector<Answer>& right, const Followers& followers) {
    Comparison<Answer> comparison(right);
    FunctionSink compare([&](const EventView& event) {
        if (const auto taken = decision_of(event)) {
            (*followers.judge)(comparison.verdict(taken->of, taken->answer, std::identity{}));
        }
        request.sink->hear(event);
    });
    RunRequest compared = request;
    compared.sink = &compare;
    return traced_run(compared, {.count = followers.count});
}

Picture compared_by_signs(const RunRequest& request, const std::vector<Sign>& right, const Followers& followers) {
    Comparison<Sign> comparison(right);
    const HearSign compare = [&](Sign sign) {
        const auto as_answer = [](Sign of) { return Answer(int(of)); };
        (*followers.judge)(comparison.verdict(Decision::comparison, sign, as_answer));
    };
    return traced_run(request, {.count = followers.count, .hear_sign = &compare});
}

}  // namespace

Picture exactly_judged_run(const RunRequest& request, const Followers& followers) {
    return traced_run(exactly(request, *request.sink), followers);
}

RightDecisions right_decisions(const RunRequest& request, const Judge* judge) {
    RightDecisions right;
    const HearSign keep_sign = [&](Sign sign) { right.signs.push_back(sign); };
    FunctionSink keep_answer([&](const EventView& event) {
        if (const auto taken = decision_of(event)) right.reported.push_back(taken->answer);
        request.sink->hear(event);
    });
    traced_run(exactly(request, keep_answer),
               {.judge = judge, .hear_sign = is_of_regions(request) ? &keep_sign : nullptr});
    return right;
}

Picture compared_run(const RunRequest& request, const RightDecisions& right, const Followers& followers) {
    return is_of_regions(request) ? compared_by_signs(request, right.signs, followers)
                                  : compared_by_answers(request, right.reported, followers);
}

Picture judged_run(const RunRequest& request, const Followers& followers) {
    if (!request.kernel.is_always_right()) return traced_run(request, followers);
    FunctionSink nobody([](const EventView&) {});
    RunRequest unreported = request;
    unreported.sink = &nobody;
    if (is_of_regions(request)) unreported.detail = Detail::windows;  // its signs are enough
    return compared_run(request, right_decisions(unreported, nullptr), followers);
}

}  // namespace vidno
