/** Comparing pictures, in a browser. */
import type { Page } from "playwright-core";

/** Mean difference of two pictures, given as addresses of their data, as a share of the largest one there can be. */
export function difference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const pixels = async (address: string) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.width, image.height];
        const context = canvas.getContext("2d")!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height).data;
      };
      const [first, second] = [await pixels(a), await pixels(b)];
      if (first.length !== second.length) throw new Error("pictures of different size");
      let sum = 0;
      for (let i = 0; i < first.length; ++i) sum += Math.abs(first[i] - second[i]);
      return sum / (255 * first.length);
    },
    [one, other] as const,
  );
}
