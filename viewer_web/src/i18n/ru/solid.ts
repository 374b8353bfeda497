import type { SolidTexts } from '../../language/texts.js';

export const solid: SolidTexts = {
  solid: '3D',
  title: 'Сцена в пространстве',
  how: 'Мышью или стрелками — повернуть, с Shift — сдвинуть; колесо, + или − — масштаб; 0 — исходный вид. Проекция ортогональная.',
  turn: 'Вид',
  views: { front: 'Спереди', side: 'Сбоку', askew: 'Аксонометрия' },
  missing: 'В этом браузере нет WebGL: видны лишь контуры многоугольников.',
  depths: (far, near) => `Чем больше z, тем ближе: от ${far} до ${near}. По глубине масштаб свой.`,
  window: (window) => `Окно ${window}: столб вдоль z.`,
  corners: (depths) => `Наибольшие глубины в его углах к этому шагу: ${depths}.`,
  plane: (polygon, depths) => `На плоскости ${polygon}: ${depths}.`,
  clip: 'Пунктир — отсечённый к этому шагу многоугольник.',
  point: (point, depths) => `На прямой через ${point}: ${depths}.`,
  noPolygon: 'нет многоугольников',
  scanline: (row, edges) => `Строка ${row}: плоскость вдоль z. Активные рёбра: ${edges}.`,
  span: (from, to) => `Отрезок (x; z): от ${from} до ${to}.`,
  pixel: (pixel, own, stored) => `Пиксель ${pixel}: глубина ${own}, в буфере ${stored}.`,
};
