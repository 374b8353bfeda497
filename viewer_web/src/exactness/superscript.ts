/** A whole number as an exponent. */
export const superscript = (exponent: number): string =>
  String(exponent).replace(/[\d-]/gu, (sign) =>
    sign === '-' ? '⁻' : ('⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(sign)] ?? ''),
  );
