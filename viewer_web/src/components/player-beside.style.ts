import { css } from 'lit';

/** Beside the text of a lesson there is less room; where there is little, the picture, and what is further down is scrolled to. */
export const playerBesideStyle = css`
  @media (max-width: 1699px) {
    :host([beside]) {
      --signs: none;
    }
  }
  @media (min-width: 900px) {
    @container (max-width: 960px) {
      :host([beside]) .panels {
        flex: 1;
        grid-template:
          minmax(0, var(--picture-share, 1.3fr)) minmax(0, 1fr) / minmax(0, 1fr)
          minmax(0, 1fr);
      }
      :host([beside]) .panels > section {
        order: 0;
        height: auto;
      }
      :host([beside]) .panels .side {
        grid-row: 1;
        grid-column: 2;
      }
      :host([beside]) .panels .listing {
        grid-row: 2;
        grid-column: 1 / -1;
      }
      :host([beside]) .dock {
        position: static;
      }
    }
  }
  @media (min-width: 900px) and (max-height: 860px) {
    :host([beside]) {
      --picture-share: 1.8fr;
    }
    :host([beside]) vidno-travel {
      display: none;
    }
    :host([beside]) .sentence {
      height: 3.2rem;
      font-size: 0.875rem;
      line-height: 1.2;
    }
  }
  /* Above the text: one sees the picture, where there is room the listing, and the sentence. */
  @media (max-width: 899px) {
    :host([beside]) {
      --legend: none;
      --strip: none;
      flex: none;
    }
    :host([beside]) vidno-travel {
      display: none;
    }
    :host([beside]) .panels {
      grid-template: calc(45dvh - 10.75rem) 20rem / minmax(0, 1.1fr) minmax(0, 1fr);
    }
    :host([beside]) .panels > section {
      order: 0;
      height: auto;
    }
    :host([beside]) .panels .listing {
      grid-row: 1;
      grid-column: 2;
    }
    :host([beside]) .panels .side {
      grid-row: 2;
      grid-column: 1 / -1;
    }
    :host([beside]) .dock {
      gap: 0.25rem;
      padding-block: 0.25rem;
    }
    :host([beside]) .sentence {
      height: 3.1rem;
      font-size: 0.8125rem;
      line-height: 1.25;
    }
  }
  @media (max-width: 640px) {
    :host([beside]) {
      gap: 0.4rem;
    }
    :host([beside]) .panels {
      grid-template: calc(45dvh - 10.75rem) 16rem 20rem / minmax(0, 1fr);
    }
    :host([beside]) .panels > section {
      border-radius: 0;
      border-inline: 0;
    }
    :host([beside]) .panels .listing {
      grid-row: 2;
      grid-column: 1;
    }
    :host([beside]) .panels .side {
      grid-row: 3;
    }
    :host([beside]) .dock {
      border-radius: 0;
      border-inline: 0;
    }
  }
`;
