package org.u2sa.sim.camera;

import java.util.Random;

/**
 * Lens and sensor model: blur, vignetting, auto-exposure that lags by a frame, white-balance error,
 * gamma, clipping and noise. Row noise depends only on image number and row, so rows may be
 * processed in any order and on several threads.
 */
final class Development {
  private static final int TONES = 4096;
  private static final int NOISES = 1024;
  private static final float TARGET = 0.20f; // target mean brightness, relative to white
  private static final float LAG = 0.35f; // exposure correction per frame
  private static final double GAMMA = 1.0 / 2.2;
  private static final double VIGNETTE = 0.25; // light loss in the corners

  private final ColourLens lens;
  private final float[] vignette;
  private final float[] tone = new float[TONES + 1];
  private final float[] noise = new float[NOISES];
  private final float[] balance;
  private final float side; // blur weight of each neighbour
  private final int seed;
  private int pictures;
  private float gain; // 0 before the first frame
  private int smear; // motion blur to each side by rotation during exposure [px]

  /** Row buffers of one thread. */
  final class Bath {
    private final int stride = 3 * lens.width();
    private final float[] raw = new float[stride];
    private float[] above = new float[stride];
    private float[] here = new float[stride];
    private float[] below = new float[stride];

    /** Converts rows of light into pixels. */
    void develop(float[] light, byte[] picture, int from, int to) {
      int last = lens.height() - 1;
      across(light, Math.max(0, from - 1), above);
      across(light, from, here);
      for (int row = from; row < to; row++) {
        across(light, Math.min(last, row + 1), below);
        boolean isRim = row == 0 || row == last;
        fix(row, isRim ? 0.0f : side, picture);
        float[] free = above;
        above = here;
        here = below;
        below = free;
      }
    }

    /** Blurs a row horizontally. */
    private void across(float[] light, int row, float[] into) {
      int at = row * stride;
      System.arraycopy(light, at, raw, 0, stride);
      if (smear > 0) {
        smear();
      }
      float middle = 1.0f - 2.0f * side;
      System.arraycopy(raw, 0, into, 0, 3);
      System.arraycopy(raw, stride - 3, into, stride - 3, 3);
      for (int i = 3; i < stride - 3; i++) {
        into[i] = middle * raw[i] + side * (raw[i - 3] + raw[i + 3]);
      }
    }

    private void smear() {
      float[] sharp = below; // filled later
      System.arraycopy(raw, 0, sharp, 0, stride);
      int count = lens.width();
      float by = 1.0f / (2 * smear + 1);
      for (int channel = 0; channel < 3; channel++) {
        float sum = 0.0f;
        for (int k = -smear; k <= smear; k++) {
          sum += sharp[3 * Math.max(0, k) + channel];
        }
        for (int x = 0; x < count; x++) {
          raw[3 * x + channel] = sum * by;
          sum += sharp[3 * Math.min(count - 1, x + smear + 1) + channel];
          sum -= sharp[3 * Math.max(0, x - smear) + channel];
        }
      }
    }

    /** Converts light to pixels. */
    private void fix(int row, float upDown, byte[] picture) {
      float middle = 1.0f - 2.0f * upDown;
      for (int i = 0; i < stride; i++) {
        raw[i] = middle * here[i] + upDown * (above[i] + below[i]);
      }
      int random = ValueNoise.mix(seed + pictures * lens.height() + row) | 1;
      int at = row * stride;
      int pixel = row * lens.width();
      for (int i = 0; i < stride; i += 3) {
        random ^= random << 13; // Marsaglia's xorshift (2003)
        random ^= random >>> 17;
        random ^= random << 5;
        float scale = gain * vignette[pixel++];
        picture[at + i] = tone(raw[i] * scale * balance[0], random);
        picture[at + i + 1] = tone(raw[i + 1] * scale, random >>> 10);
        picture[at + i + 2] = tone(raw[i + 2] * scale * balance[2], random >>> 20);
      }
    }
  }

  Development(ColourLens lens, Light light, Random random) {
    this.lens = lens;
    side = 0.25f * (float) Math.min(1.0, lens.blurPixels());
    for (int i = 0; i <= TONES; i++) {
      tone[i] =
          (float) (255.0 * StrictMath.pow((double) i / TONES, GAMMA)) + 0.5f; // rounds to nearest
    }
    for (int i = 0; i < NOISES; i++) {
      noise[i] = (float) (255.0 * lens.sigma() * random.nextGaussian());
    }
    double warm = 0.15 * light.warmth();
    balance = new float[] {(float) (1.0 + warm), 1.0f, (float) (1.0 - warm)};
    seed = random.nextInt();
    vignette = new float[lens.width() * lens.height()];
    double corner = 0.25 * (lens.width() * lens.width() + lens.height() * lens.height());
    for (int i = 0; i < vignette.length; i++) {
      double x = i % lens.width() - 0.5 * lens.width();
      double y = i / lens.width() - 0.5 * lens.height();
      vignette[i] = (float) (1.0 - VIGNETTE * (x * x + y * y) / corner);
    }
  }

  Bath bath() {
    return new Bath();
  }

  /**
   * Prepares the next image.
   *
   * @param light red, green, blue of each pixel, linear
   * @param turnRad camera yaw during one row's exposure [rad]
   */
  void begin(float[] light, double turnRad) {
    smear = (int) Math.round(0.5 * Math.abs(turnRad) * lens.intrinsics().focalX());
    pictures++;
    expose(light);
  }

  private byte tone(float value, int random) {
    int level = Math.min(TONES, (int) (value * TONES));
    int bright = (int) (tone[level] + noise[random & NOISES - 1]);
    return (byte) Math.max(0, Math.min(255, bright));
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
}
