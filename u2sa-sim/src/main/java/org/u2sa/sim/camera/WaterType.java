package org.u2sa.sim.camera;

/**
 * Jerlov's optical water types: diffuse attenuation of downward irradiance [1/m] at 600, 525 and
 * 450 nm, taken for the red, green and blue channels (Jerlov, Marine Optics, 2nd ed., 1976, table
 * XXVII). I is the clearest ocean, C7 a turbid harbour; a filtered pool resembles IB.
 */
public enum WaterType {
  I(0.235f, 0.043f, 0.019f),
  IB(0.245f, 0.054f, 0.036f),
  II(0.260f, 0.076f, 0.068f),
  III(0.295f, 0.116f, 0.135f),
  C1(0.300f, 0.130f, 0.250f),
  C3(0.330f, 0.200f, 0.390f),
  C5(0.400f, 0.310f, 0.560f),
  C7(0.480f, 0.490f, 0.890f);

  private final float[] diffuse;

  WaterType(float red, float green, float blue) {
    diffuse = new float[] {red, green, blue};
  }

  /** Diffuse attenuation of a channel [1/m]: 0 red, 1 green, 2 blue. */
  public float diffuse(int channel) {
    return diffuse[channel];
  }
}
