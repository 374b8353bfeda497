/// Deviation: a place of a procedure that may run differently from the corrected text. The defects of the printed text
/// and the usual mistakes are one table, from which editions, command line, page and atlas take them.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "choice/language.h"
#include "vidno/line.h"
#include "vidno/method.h"

namespace vidno {

/// First the defects of the printed text (vidno/printed.h), then the usual mistakes (vidno/mistakes/).
enum class Deviation : unsigned char {
    x_w1,
    x_w2,
    x_w3,
    x_w4,
    x_w5,
    x_w6,
    x_w7,
    x_w8,
    x_z1,
    x_z2,
    x_z3,
    x_z4,
    x_z5,
    x_z6,
    x_z7,
    x_h1,
    x_h2,
    x_h3,
    x_h4,
    x_h5,
    x_h6,
    one_list,  // the printed text makes it too: X-W9
    depths_not_cleared,
    clip_order_reversed,
    y_flipped,
    depth_sign_reversed,
    boundary_outside,
    integer_division,
    surround_kept,
    vertex_counted_twice,
    octants_not_split,
    line_for_edge
};

struct DeviationChoice {
    std::string_view defect{};    // the id of the defect, if the printed text has it
    std::string_view mistake{};   // its name as an edition, if it is a usual mistake
    Bilingual title;              // for a defect, its id
    Bilingual says;               // what it does
    std::span<const Line> lines;  // the lines of the listings that it changes
    // How a usual mistake writes these lines, in order. The listings have the lines of the printed text.
    std::array<Bilingual, 2> reads{};
    std::span<const Method> methods;  // none: the floating horizon
    std::string_view witness;         // the file of lessons/failures that shows it, without its ending
    Bilingual advice{};  // for students whose program makes the mistake; none if they do not write such a method
};

namespace deviation {

template <Line... labels>
inline constexpr std::array at{labels...};
template <Method... each>
inline constexpr std::array of{each...};
inline constexpr std::span<const Method> of_curves{};

constexpr Bilingual untranslated(std::string_view text) { return {text, text}; }

}  // namespace deviation

/// Indexed by Deviation.
inline constexpr auto deviations = [] {
    using namespace deviation;
    using enum Line;
    using enum Method;
    return std::to_array<DeviationChoice>({
        {.defect = "x-w1",
         .title = untranslated("X-W1"),
         .says = {"a polygon leaves the list if it surrounds the window, and one outside stays in it",
                  "из списка уходит охватывающий многоугольник, а внешний остаётся"},
         .lines = at<PW3>,
         .methods = of<warnock>,
         .witness = "x-w1"},
        {.defect = "x-w2",
         .title = untranslated("X-W2"),
         .says = {"the corner depths start at 0, so what lies behind z = 0 is never the nearest",
                  "глубины в углах начинаются с 0, и лежащее за z = 0 никогда не ближайшее"},
         .lines = at<PW1>,
         .methods = of<warnock>,
         .witness = "x-w2"},
        {.defect = "x-w3",
         .title = untranslated("X-W3"),
         .says = {"a polygon that is nearest at all four corners does not reset hasSurround",
                  "многоугольник, ближайший во всех четырёх углах, не отменяет охватывающий, найденный до него"},
         .lines = at<PW7>,
         .methods = of<warnock>,
         .witness = "x-w3"},
        {.defect = "x-w4",
         .title = untranslated("X-W4"),
         .says = {"the search for the first sign runs past the last edge",
                  "поиск первого знака не останавливается на последнем ребре"},
         .lines = at<S2>,
         .methods = of<warnock>,
         .witness = "x-w4"},
        {.defect = "x-w5",
         .title = untranslated("X-W5"),
         .says = {"an area of any size is halved, so that windows end inside pixels",
                  "пополам делится область любого размера, и границы окон проходят внутри пикселей"},
         .lines = at<W3, W13>,
         .methods = of<warnock>,
         .witness = "x-w5"},
        {.defect = "x-w6",
         .title = untranslated("X-W6"),
         .says = {"the plane is that of the first three vertices, even if these are collinear",
                  "плоскость строится по первым трём вершинам, даже если они лежат на одной прямой"},
         .lines = at<I1>,
         .methods = of<warnock, zbuffer>,
         .witness = "x-w6"},
        {.defect = "x-w7",
         .title = untranslated("X-W7"),
         .says = {"signs are compared by a product, which becomes 0 if both factors are tiny",
                  "знаки сравниваются по произведению, а оно при малых множителях обращается в 0"},
         .lines = at<PL5>,
         .methods = of<warnock>,
         .witness = "x-w7"},
        {.defect = "x-w8",
         .title = untranslated("X-W8"),
         .says = {"c as computed decides whether a polygon is edge-on",
                  "виден ли многоугольник с ребра, решает вычисленное значение c"},
         .lines = at<W2>,
         .methods = of<warnock>,
         .witness = "x-w8"},
        {.defect = "x-z1",
         .title = untranslated("X-Z1"),
         .says = {"edges enter by rounded y and leave by unrounded y, so that three may be active at once",
                  "рёбра входят по округлённому y, а уходят по неокруглённому: активных бывает и три"},
         .lines = at<Z8, Z16>,
         .methods = of<zbuffer>,
         .witness = "x-z1-alone"},
        {.defect = "x-z2",
         .title = untranslated("X-Z2"),
         .says = {"a line is skipped only if it lies both to the left and to the right of the area, that is, never",
                  "строка пропускается, только если лежит сразу и левее, и правее области, то есть никогда"},
         .lines = at<L2>,
         .methods = of<zbuffer>,
         .witness = "x-z2"},
        {.defect = "x-z3",
         .title = untranslated("X-Z3"),
         .says = {"the row and the column just past the area are included",
                  "строка и столбец сразу за областью тоже развёртываются"},
         .lines = at<L1, L5>,
         .methods = of<zbuffer>,
         .witness = "x-z3-alone"},
        {.defect = "x-z4",
         .title = untranslated("X-Z4"),
         .says = {"the slope of a span of one point is 0 divided by 0",
                  "наклон отрезка из одной точки есть 0, делённый на 0"},
         .lines = at<L3>,
         .methods = of<zbuffer>,
         .witness = "x-z4-alone"},
        {.defect = "x-z5",
         .title = untranslated("X-Z5"),
         .says = {"a span starts at its left end, not at a pixel's centre",
                  "отрезок начинается в своём левом конце, а не в центре пикселя"},
         .lines = at<L4>,
         .methods = of<zbuffer>,
         .witness = "x-z5"},
        {.defect = "x-z6",
         .title = untranslated("X-Z6"),
         .says = {"the scanline starts at the polygon's ymin, not at a row's centre",
                  "развёртка начинается с ymin многоугольника, а не с центра строки пикселей"},
         .lines = at<Z5>,
         .methods = of<zbuffer>,
         .witness = "x-z6-alone"},
        {.defect = "x-z7",
         .title = untranslated("X-Z7"),
         .says = {"the last of equally near polygons is shown, and Z starts at −1",
                  "из одинаково близких виден последний, а Z начинается с −1"},
         .lines = at<Z1, L6>,
         .methods = of<zbuffer>,
         .witness = "x-z7"},
        {.defect = "x-h1",
         .title = untranslated("X-H1"),
         .says = {"a minus sign is lost: what lies below is not drawn, and an edge at x = 1 counts as absent",
                  "потерян минус: лежащее снизу не рисуется, а ребро при x = 1 считается отсутствующим"},
         .lines = at<FH1, FH6, SE1>,
         .methods = of_curves,
         .witness = "x-h1"},
        {.defect = "x-h2",
         .title = untranslated("X-H2"),
         .says = {"a curve that emerges below is cut by the upper horizon",
                  "выходящее снизу обрезается верхним горизонтом"},
         .lines = at<FH8>,
         .methods = of_curves,
         .witness = "x-h2"},
        {.defect = "x-h3",
         .title = untranslated("X-H3"),
         .says = {"the horizons start at the sides of the screen, and are never empty",
                  "горизонты начинаются от сторон экрана и не бывают пустыми"},
         .lines = at<FH1>,
         .methods = of_curves,
         .witness = "x-h3"},
        {.defect = "x-h4",
         .title = untranslated("X-H4"),
         .says = {"a curve is compared with horizons that it has raised itself",
                  "кривая сравнивается с горизонтами, которые сама же подняла"},
         .lines = at<FH4, SE2>,
         .methods = of_curves,
         .witness = "x-h4"},
        {.defect = "x-h5",
         .title = untranslated("X-H5"),
         .says = {"only samples are examined, not the columns between them",
                  "рассматриваются только отсчёты, а не столбцы между ними"},
         .lines = at<FH5>,
         .methods = of_curves,
         .witness = "x-h5"},
        {.defect = "x-h6",
         .title = untranslated("X-H6"),
         .says = {"a point on both horizons counts as one above", "точка на обоих горизонтах считается лежащей сверху"},
         .lines = at<V2>,
         .methods = of_curves,
         .witness = "x-h6"},
        {.defect = "x-w9",
         .mistake = "one-list",
         .title = {"one list for all parts", "один список на все части"},
         .says = {"all parts of a window share one list", "у всех частей окна один общий список"},
         .lines = at<W13>,
         .reads = {{{"else: push each quarter of U that overlaps the area, with APL itself",
                     "иначе: положить четверти U, кроме лежащих вне области, каждую с самим APL"}}},
         .methods = of<warnock>,
         .witness = "mistake-one-list",
         .advice = {"all parts of a window share one APL: a polygon that leaves it in one part is missing in the "
                    "others. Give "
                    "each part a copy",
                    "у всех частей окна один APL: что ушло из него в одной части, пропадает и в остальных. Дайте "
                    "каждой части копию"}},
        {.mistake = "depths-not-cleared",
         .title = {"Z not cleared", "Z не очищен"},
         .says = {"Z starts at 0, as a new array does", "Z начинается с 0, как новый массив"},
         .lines = at<Z1>,
         .reads = {{{"fill the area with the background; Z holds 0, as a new array does",
                     "заполнить область цветом фона; в Z нули, как в новом массиве"}}},
         .methods = of<zbuffer>,
         .witness = "mistake-depths-not-cleared",
         .advice = {"the depths are not cleared: they start at 0, and what lies behind 0 is never shown. Start below "
                    "all depths",
                    "глубины не очищены: они начинаются с 0, и лежащее за этой глубиной не видно никогда. Начните с "
                    "глубины, меньшей всех"}},
        {.mistake = "clip-order-reversed",
         .title = {"clip order reversed", "обратный порядок отсечения"},
         .says = {"the window's corners are taken in the opposite order, so that inside and outside change places",
                  "углы окна берутся в обратном порядке, и внутренняя сторона становится внешней"},
         .lines = at<PL1>,
         .reads = {{untranslated("F := (xmax, ymin), (xmax, ymax), (xmin, ymax), (xmin, ymin); f₀ := F₄, P′ := P")}},
         .methods = of<warnock>,
         .witness = "mistake-clip-order-reversed",
         .advice = {"clipping takes the sides of the window in the opposite direction, so that inside and outside "
                    "change places. Reverse the order of its corners, or the sign",
                    "при отсечении стороны окна обходятся в обратную сторону, и внутренняя сторона становится "
                    "внешней. Измените порядок углов или знак"}},
        {.mistake = "y-flipped",
         .title = {"y flipped", "y перевёрнут"},
         .says = {"y grows upward: the picture is upside down", "y растёт вверх: изображение перевёрнуто"},
         .lines = at<I1>,
         .reads = {{untranslated(
             "yᵢ := 2·Wcy + Wy − yᵢ; (a, b, c) := Σᵢ (pᵢ − p₁) × (pᵢ₊₁ − p₁), d := −(a·x₁ + b·y₁ + c·z₁)")}},
         .methods = of<warnock, zbuffer>,
         .witness = "mistake-y-flipped",
         .advice = {"the picture is upside down: y grows downward, row 0 is the uppermost",
                    "изображение перевёрнуто: y растёт вниз, строка 0 — верхняя"}},
        {.mistake = "depth-sign-reversed",
         .title = {"sign of z reversed", "обратный знак z"},
         .says = {"the smaller z is nearer", "ближе тот, у кого z меньше"},
         .lines = at<D1>,
         .reads = {{untranslated("z := (a·x + b·y + d) / c")}},
         .methods = of<warnock, zbuffer>,
         .witness = "mistake-depth-sign-reversed",
         .advice = {"the sign of z is reversed: the greater z is the nearer",
                    "перепутан знак z: ближе тот, у кого z больше"}},
        {.mistake = "boundary-outside",
         .title = {"boundary outside", "контур снаружи"},
         .says = {"points on the outline count as outside", "точки контура считаются внешними"},
         .lines = at<S3, L4>,
         .reads = {{{"for each edge e: if σ(e) = 0 or σ(e) ≠ Sgn₁: return false",
                     "для каждого ребра e: если σ(e) = 0 или σ(e) ≠ Sgn₁: вернуть false"},
                    {"x := first pixel centre > x₁, in the area; the last one is < x₂; z := z₁ + (x − x₁)Δz",
                     "x := первый центр пикселя > x₁ в области; последний < x₂; z := z₁ + (x − x₁)Δz"}}},
         .methods = of<warnock, zbuffer>,
         .witness = "mistake-boundary-outside",
         .advice = {"points on an outline count as outside both polygons that share it: pixels there belong to "
                    "neither. Let a product of 0 count as inside, or give such points to one of the two",
                    "точки общего ребра считаются внешними для обоих многоугольников, и пиксели там ничьи. Пусть "
                    "нулевое произведение значит «внутри», или отдайте такие точки одному из двух"}},
        {.mistake = "integer-division",
         .title = {"integer division", "деление нацело"},
         .says = {"the area is halved in whole numbers, and the rest is lost",
                  "область делится пополам нацело, и остаток теряется"},
         .lines = at<W3, W13>,
         .reads = {{{"push (Wcx, Wcy, Wx, Wy, APL₀) on AW", "положить (Wcx, Wcy, Wx, Wy, APL₀) в AW"},
                    {"else: push the parts of U, its sides halved in whole numbers, each with a copy of APL",
                     "иначе: положить части U, стороны которого делятся пополам нацело, каждую с копией APL"}}},
         .methods = of<warnock>,
         .witness = "mistake-integer-division",
         .advice = {"a window is halved in whole numbers: if its side is odd, a column or row is lost. Begin with "
                    "a square of 2^m pixels a side that covers the area",
                    "окно делится пополам нацело: при нечётной стороне теряется столбец или строка. Начните с "
                    "квадрата со стороной 2^m пикселей, накрывающего область"}},
        {.mistake = "surround-kept",
         .title = {"hasSurround never reset", "hasSurround не сбрасывается"},
         .says = {"hasSurround is never reset", "hasSurround никогда не сбрасывается"},
         .lines = at<PW7>,
         .reads = {{{"if k > 0: nothing; hasSurround stays", "если k > 0: ничего; hasSurround остаётся"}}},
         .methods = of<warnock>,
         .witness = "mistake-surround-kept",
         .advice = {"hasSurround is never reset: a polygon that lies in front of the surrounding one in a part of the "
                    "window is overlooked. Set it to false wherever a nearer polygon is found",
                    "hasSurround не сбрасывается: многоугольник, который в части окна ближе охватывающего, "
                    "пропускается. Сбрасывайте его всякий раз, когда найден более близкий многоугольник"}},
        {.mistake = "vertex-counted-twice",
         .title = {"pierced vertex counted twice", "проткнутая вершина за два"},
         .says = {"a ray crosses a vertex twice, whether it is pierced or touched",
                  "луч пересекает вершину дважды, проткнута она или задета"},
         .lines = at<CR3>,
         .reads = {{{"if p is on the ray: n := n + 2", "если p на луче: n := n + 2"}}},
         .methods = of<warnock_full>,
         .witness = "mistake-vertex-counted-twice"},
        {.mistake = "octants-not-split",
         .title = {"straight angle not split", "развёрнутый угол не разбит"},
         .says = {"an edge that subtends a straight angle is not split",
                  "ребро, видимое под развёрнутым углом, не разбивается"},
         .lines = at<OA4>,
         .reads = {{{"if Δ = ±4: Δ as it is", "если Δ = ±4: Δ как есть"}}},
         .methods = of<warnock_angles>,
         .witness = "mistake-octants-not-split"},
        {.mistake = "line-for-edge",
         .title = {"line taken for edge", "прямая вместо ребра"},
         .says = {"an edge counts as the whole line on which it lies",
                  "вместо ребра берётся вся прямая, на которой оно лежит"},
         .lines = at<TF3>,
         .reads = {{{"if f has both signs there: return true", "если f там обоих знаков: вернуть true"}}},
         .methods = of<warnock_full>,
         .witness = "mistake-line-for-edge"},
    });
}();
static_assert(deviations.size() == std::size_t(Deviation::line_for_edge) + 1);
static_assert(std::all_of(deviations.begin(), deviations.end(),
                          [](const DeviationChoice& each) {
                              const auto has_text = [](const Bilingual& read) { return !read.english.empty(); };
                              const auto texts = std::count_if(each.reads.begin(), each.reads.end(), has_text);
                              return texts == (each.mistake.empty() ? 0 : std::ssize(each.lines));
                          }),
              "a mistake says how it writes each of its lines");

constexpr const DeviationChoice& choice_of(Deviation deviation) { return deviations[std::size_t(deviation)]; }

}  // namespace vidno
