// What a page shows that was opened without a link: its system, and the question whose answer is its first picture.

export const firstSystem = `title  Koch curve
axiom  F
F -> F+F--F+F
angle  60
generation 4
`;

export interface FirstQuestion {
  question: string;
  text: string;
  pixels: number;
}

/** Asked in the detail of the whole screen, so the answer is fine enough for any canvas on it. */
export function firstQuestion(pixels = Math.round(Math.max(screen.width, screen.height) * devicePixelRatio)): FirstQuestion {
  return { question: 'figure', text: firstSystem, pixels };
}
