/** Comparing pictures, in a browser. */
import type { Page } from "playwright-core";

/**
 * Mean difference of two pictures, given as addresses of their data, as a share of the largest one there can be. The
 * second may have more pixels, and is drawn as large as the first.
 */
export function difference(page: Page, one: string, other: string): Promise<number> {
  return page.evaluate(
    async ([a, b]) => {
      const decoded = async (address: string) => {
        const image = new Image();
        image.src = address;
        await image.decode();
        return image;
      };
      const [one, other] = [await decoded(a), await decoded(b)];
      const { width, height } = one;
      if (Math.abs(width * other.height - height * other.width) > width) throw new Error("pictures of different shape");
      const pixels = (image: HTMLImageElement) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [width, height];
        const context = canvas.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(image, 0, 0, width, height);
        return context.getImageData(0, 0, width, height).data;
      };
      const [first, second] = [pixels(one), pixels(other)];
      let sum = 0;
      for (let i = 0; i < first.length; ++i) sum += Math.abs(first[i] - second[i]);
      return sum / (255 * first.length);
    },
    [one, other] as const,
  );
}
