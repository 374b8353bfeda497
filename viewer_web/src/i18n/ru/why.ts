import type { WhyTexts } from '../../language/texts.js';

export const why: WhyTexts = {
  title: 'Почему, по каждому многоугольнику',
  others: (n) => `и те, что не содержат центра: ${n}`,
  more: (n) => `ещё ${n}`,
  depths: (all) => `Глубины в центре, ближайшая сверху: ${all}`,
  nearer: 'ближе',
};
