/** Milliseconds that a run must stay before more is made of it than a frame needs: while a scene is dragged, none does. */
export const rest = 150;
