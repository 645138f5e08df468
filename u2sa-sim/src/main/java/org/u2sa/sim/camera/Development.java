package org.u2sa.sim.camera;

import java.util.Random;

/**
 * What lens and sensor make of light: blur, vignette, exposure that follows the mean brightness a
 * frame late, white balance that is not quite right, gamma, clipping and noise. For one thread.
 */
final class Development {
  private static final int TONES = 4096;
  private static final int NOISES = 1024;
  private static final float TARGET = 0.20f; // mean brightness that exposure aims at, of white
  private static final float LAG = 0.35f; // share by which exposure follows in a frame
  private static final double GAMMA = 1.0 / 2.2;
  private static final double VIGNETTE = 0.25; // light lost in the corners

  private final ColourLens lens;
  private final float[] row;
  private final float[] vignette;
  private final float[] tone = new float[TONES + 1];
  private final float[] noise = new float[NOISES];
  private final float[] balance;
  private int state;
  private float gain; // 0: no frame yet

  Development(ColourLens lens, Light light, Random random) {
    this.lens = lens;
    row = new float[3 * Math.max(lens.width(), lens.height())];
    for (int i = 0; i <= TONES; i++) {
      tone[i] = (float) (255.0 * StrictMath.pow((double) i / TONES, GAMMA));
    }
    for (int i = 0; i < NOISES; i++) {
      noise[i] = (float) (255.0 * lens.sigma() * random.nextGaussian());
    }
    double warm = 0.15 * light.warmth();
    balance = new float[] {(float) (1.0 + warm), 1.0f, (float) (1.0 - warm)};
    state = random.nextInt() | 1;
    vignette = new float[lens.width() * lens.height()];
    double corner = 0.25 * (lens.width() * lens.width() + lens.height() * lens.height());
    for (int i = 0; i < vignette.length; i++) {
      double x = i % lens.width() - 0.5 * lens.width();
      double y = i / lens.width() - 0.5 * lens.height();
      vignette[i] = (float) (1.0 - VIGNETTE * (x * x + y * y) / corner);
    }
  }

  /**
   * @param light red, green, blue of each pixel, linear; used up
   * @param turnRad by which the camera yaws while it exposes [rad]
   */
  byte[] develop(float[] light, double turnRad) {
    int smear = (int) Math.round(0.5 * Math.abs(turnRad) * lens.intrinsics().focalX());
    blur(light, smear);
    expose(light);
    byte[] picture = new byte[light.length];
    int random = state;
    for (int i = 0; i < vignette.length; i++) {
      random ^= random << 13; // Marsaglia's xorshift (2003)
      random ^= random >>> 17;
      random ^= random << 5;
      float scale = gain * vignette[i];
      picture[3 * i] = tone(light[3 * i] * scale * balance[0], random);
      picture[3 * i + 1] = tone(light[3 * i + 1] * scale, random >>> 10);
      picture[3 * i + 2] = tone(light[3 * i + 2] * scale * balance[2], random >>> 20);
    }
    state = random;
    return picture;
  }

  private byte tone(float value, int random) {
    float clipped = value >= 1.0f ? 1.0f : value;
    float bright = tone[(int) (clipped * TONES)] + noise[random & NOISES - 1];
    return (byte) (bright <= 0.0f ? 0 : bright >= 255.0f ? 255 : (int) (bright + 0.5f));
  }

  private void expose(float[] light) {
    double sum = 0.0;
    int count = 0;
    int first = light.length / 3 / 3 * 3; // the upper third is mostly sky
    for (int i = first + 1; i < light.length; i += 51) {
      sum += Math.min(2.0f, light[i]);
      count++;
    }
    float wanted = TARGET / Math.max(1.0e-4f, (float) (sum / count));
    gain = gain == 0.0f ? wanted : gain + LAG * (wanted - gain);
  }

  private void blur(float[] light, int smear) {
    float side = 0.25f * (float) Math.min(1.0, lens.blurPixels());
    int width = lens.width();
    int height = lens.height();
    for (int y = 0; y < height; y++) {
      int at = 3 * y * width;
      if (smear > 0) {
        smear(light, at, width, smear);
      }
      if (side > 0.0f) {
        soften(light, at, width, 3, side);
      }
    }
    if (side > 0.0f) {
      columns(light, width, height, side);
    }
  }

  private void soften(float[] light, int at, int count, int stride, float side) {
    float middle = 1.0f - 2.0f * side;
    System.arraycopy(light, at, row, 0, 3 * count);
    for (int i = stride; i < 3 * (count - 1); i++) {
      light[at + i] = middle * row[i] + side * (row[i - stride] + row[i + stride]);
    }
  }

  /** The same down the columns, row by row for the memory's sake. */
  private void columns(float[] light, int width, int height, float side) {
    float middle = 1.0f - 2.0f * side;
    int stride = 3 * width;
    float[] above = new float[stride];
    System.arraycopy(light, 0, above, 0, stride);
    for (int y = 1; y < height - 1; y++) {
      int at = y * stride;
      for (int i = 0; i < stride; i++) {
        float here = light[at + i];
        light[at + i] = middle * here + side * (above[i] + light[at + stride + i]);
        above[i] = here;
      }
    }
  }

  private void smear(float[] light, int at, int count, int reach) {
    System.arraycopy(light, at, row, 0, 3 * count);
    float by = 1.0f / (2 * reach + 1);
    for (int channel = 0; channel < 3; channel++) {
      float sum = 0.0f;
      for (int k = -reach; k <= reach; k++) {
        sum += row[3 * Math.max(0, k) + channel];
      }
      for (int x = 0; x < count; x++) {
        light[at + 3 * x + channel] = sum * by;
        sum += row[3 * Math.min(count - 1, x + reach + 1) + channel];
        sum -= row[3 * Math.max(0, x - reach) + channel];
      }
    }
  }
}
