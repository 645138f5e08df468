package org.u2sa.scenarios.suas;

import java.util.List;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.world.Terrain;

/** Colours of a field's ground: patches of grass and winding paths, fixed to the ground. */
final class FieldGround {
  private static final int[] GRASS = {92, 118, 62};
  private static final int[] PATH = {16, -4, 14}; // difference from the colour of grass
  private static final int PATCH = 9; // brightness
  private static final double CELL_M = 0.75;
  private static final int CELLS = 512; // a power of 2; the pattern then repeats
  private static final int PATHS = 4;
  private static final double PATH_M = 1.5; // half the path width

  private final byte[] brightness = new byte[CELLS * CELLS];
  private final boolean[] isPath = new boolean[CELLS * CELLS];
  private final List<Point> area; // corners of the search area
  private final List<SuasTarget> targets;
  private final Terrain terrain;

  FieldGround(List<Point> area, List<SuasTarget> targets, Terrain terrain, long seed) {
    this.area = area;
    this.targets = targets;
    this.terrain = terrain;
    Random random = new Random(seed ^ 0x2545F491L);
    for (int i = 0; i < brightness.length; i++) {
      brightness[i] = (byte) (random.nextInt(2 * PATCH + 1) - PATCH);
    }
    double spacing = (double) CELLS / PATHS;
    for (int i = 0; i < isPath.length; i++) {
      double bend = 0.25 * spacing * Math.sin(2.0 * Math.PI * 3.0 * (i % CELLS) / CELLS);
      double away = Math.IEEEremainder(i / CELLS + bend, spacing);
      isPath[i] = Math.abs(away) * CELL_M < PATH_M;
    }
  }

  /**
   * Depth below a camera at which a ray meets the ground [m], found iteratively.
   *
   * @param right distance east per metre down
   * @param ahead distance north per metre down
   * @param nearly the result for a neighbouring ray, as a first guess
   */
  double away(Point camera, double right, double ahead, double nearly) {
    return terrain.steepest() > 0.0
        ? camera.z() - terrain.heightM(camera.x() + nearly * right, camera.y() + nearly * ahead)
        : camera.z();
  }

  /** Whether a camera there may see the search area. */
  boolean isSeenFrom(Point camera) {
    return SuasField.isInside(area, camera.x(), camera.y())
        || SuasField.edgeM(area, camera.x(), camera.y()) < 2.0 * camera.z();
  }

  private static int cell(double metres) {
    return (int) Math.floor(metres / CELL_M) & CELLS - 1;
  }

  /**
   * Colour of the ground without targets, 0…255.
   *
   * @param channel 0 red, 1 green, 2 blue
   */
  int bare(int channel, double eastM, double northM) {
    return GRASS[channel] + shade(channel, eastM, northM);
  }

  /** Difference of the ground's colour from that of grass. */
  int shade(int channel, double eastM, double northM) {
    int at = cell(northM) * CELLS + cell(eastM);
    return brightness[at] + (isPath[at] ? PATH[channel] : 0);
  }

  /** Colour of the ground with targets, 0…255. */
  int colour(int channel, Point place) {
    for (SuasTarget target : targets) {
      int[] paint = target.paint(place.x(), place.y());
      if (paint != null) {
        return paint[channel];
      }
    }
    return bare(channel, place.x(), place.y());
  }
}
