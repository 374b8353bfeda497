import { css } from 'lit';

/** Small samples of the textures of differing pixels. */
export const textureStyle = css`
  i {
    display: inline-block;
    width: 1rem;
    height: 0.75rem;
    margin-right: 0.3rem;
    border-radius: 2px;
    vertical-align: -0.05em;
    background: #ffffff;
  }
  i.wrong {
    background: repeating-linear-gradient(135deg, #10131c 0 3px, #ffffff 3px 6px);
  }
  i.lacking {
    background: radial-gradient(#10131c 1px, #ffffff 1.4px) 0 0 / 4px 4px;
  }
`;
