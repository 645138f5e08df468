package org.u2sa.sim.camera;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.world.Ramp;

/**
 * Visual model of a world: painted lawn, solids and shadows. An object's type determines its
 * appearance: {@code white line} and {@code worn line} (PolyLine), {@code pothole} (Circle: a white
 * disc of paint), {@code barrel}, {@code red flag} and {@code blue flag} (Cylinder), {@code
 * sawhorse} (Box), {@code ramp} (PolyLine: its profile along its centre line); other cylinders and
 * boxes are grey. Other objects without volume are invisible. Immutable and shareable between
 * cameras.
 */
public final class Scenery {
  /** Freshly painted. */
  public static final String LINE = "white line";

  /** Paint half worn away. */
  public static final String WORN_LINE = "worn line";

  /** A white disc on the ground, as IGVC marks potholes. */
  public static final String POTHOLE = "pothole";

  /** Orange with white bands. */
  public static final String BARREL = "barrel";

  /** A trestle with a striped plank. */
  public static final String SAWHORSE = "sawhorse";

  /** A small flag on a pole. */
  public static final String RED_FLAG = "red flag";

  /** A small flag on a pole. */
  public static final String BLUE_FLAG = "blue flag";

  /** Boards across a lane that rise and fall; paint lies on them. */
  public static final String RAMP = "ramp";

  private static final double LEG_M = 0.03;
  private static final int SKYLINE = 1024;
  private static final float FULL_TURN = 4.0f;

  final Lawn lawn;
  final List<Solid> solids;
  final Light light;
  final float[] sun; // unit vector toward the sun: east, north, up
  private final float[] skyline; // slope to the tree tops all around, indexed by {@link #turn}

  /**
   * @param objects in LOCAL_ENU
   * @param seed random seed of grass, wear and trees
   */
  public Scenery(List<? extends ObjectDescription> objects, Light light, long seed) {
    this.light = light;
    double flat = StrictMath.cos(light.sunElevationRad());
    double[] sunward = {
      flat * StrictMath.sin(light.sunAzimuthRad()),
      flat * StrictMath.cos(light.sunAzimuthRad()),
      StrictMath.sin(light.sunElevationRad())
    };
    sun = new float[] {(float) sunward[0], (float) sunward[1], (float) sunward[2]};
    List<Solid> standing = new ArrayList<>();
    objects.forEach(object -> stand(object, standing));
    LawnPainter painter = new LawnPainter(LawnPainter.bounds(objects), seed);
    for (ObjectDescription object : objects) {
      if (object instanceof PolyLine profile && object.objectType().equals(RAMP)) {
        Boards boards = new Boards(new Ramp(profile.points(), profile.width()));
        standing.add(boards);
        painter.boards(boards.outline());
      }
    }
    solids = List.copyOf(standing);
    for (ObjectDescription object : objects) {
      if (object instanceof PolyLine line && isLine(object)) {
        painter.line(line.points(), line.width(), object.objectType().equals(WORN_LINE));
      } else if (object instanceof Circle disc && object.objectType().equals(POTHOLE)) {
        painter.disc(disc.x(), disc.y(), disc.radius());
      }
    }
    if (light.cloudShadows() > 0.0) {
      painter.clouds(light.cloudShadows());
    }
    for (Solid solid : solids) {
      double[] outline = solid.shadow(sunward[0], sunward[1], sunward[2]);
      if (outline.length > 0) {
        painter.shadow(outline);
      }
    }
    lawn = painter.lawn();
    skyline = skyline(new ValueNoise(seed + 1));
  }

  private static float[] skyline(ValueNoise noise) {
    float[] slopes = new float[SKYLINE];
    for (int i = 0; i < slopes.length; i++) {
      double[] way = way((i + 0.5) * FULL_TURN / slopes.length);
      double rough = noise.fractal(9.0 * way[0], 9.0 * way[1], 4);
      slopes[i] = (float) Math.max(0.005, 0.06 + 0.09 * rough);
    }
    return slopes;
  }

  /** Unit vector of a pseudo-angle. */
  private static double[] way(double turn) {
    double x = Math.abs(turn - 2.0) - 1.0;
    double y = (turn < 2.0 ? 1.0 : -1.0) * (1.0 - Math.abs(x));
    double length = Math.sqrt(x * x + y * y);
    return new double[] {x / length, y / length};
  }

  /** Pseudo-angle of a vector (diamond angle), 0 to 4: monotonic in the angle but cheaper. */
  private static float turn(float x, float y) {
    float part = x / (Math.abs(x) + Math.abs(y));
    return y >= 0.0f ? 1.0f - part : 3.0f + part;
  }

  /** Tree-line elevation in a direction, as a slope. */
  float treesUp(float east, float north) {
    int place = (int) (turn(east, north) * (SKYLINE / FULL_TURN));
    return skyline[Math.max(0, Math.min(SKYLINE - 1, place))];
  }

  private static boolean isLine(ObjectDescription object) {
    return object.objectType().equals(LINE) || object.objectType().equals(WORN_LINE);
  }

  private static void stand(ObjectDescription object, List<Solid> solids) {
    float x = (float) object.x();
    float y = (float) object.y();
    if (object instanceof Cylinder cylinder) {
      float height = (float) cylinder.height();
      switch (object.objectType()) {
        case BARREL -> solids.add(Drum.barrel(x, y, cylinder.radius(), height));
        case RED_FLAG -> flag(x, y, height, Reflectance.RED, solids);
        case BLUE_FLAG -> flag(x, y, height, Reflectance.BLUE, solids);
        default ->
            solids.add(
                new Drum(
                    x, y, 0.0f, (float) cylinder.radius(), height, new int[] {Reflectance.GREY}));
      }
    } else if (object instanceof Box box) {
      box(box, object.objectType().equals(SAWHORSE), solids);
    }
  }

  private static void flag(float x, float y, float height, int colour, List<Solid> solids) {
    solids.add(new Drum(x, y, 0.0f, 0.012f, height, new int[] {Reflectance.STEEL}));
    float turn = 2.4f * x + 1.7f * y; // arbitrary direction across the lawn
    float cos = (float) StrictMath.cos(turn);
    float sin = (float) StrictMath.sin(turn);
    float half = 0.16f;
    solids.add(
        new Board(
            x + half * cos,
            y + half * sin,
            cos,
            sin,
            half,
            height - 0.26f,
            height,
            colour,
            0,
            0.0f));
  }

  /** Two planks and four legs, or four walls. */
  private static void box(Box box, boolean isSawhorse, List<Solid> solids) {
    double cos = StrictMath.cos(box.psi());
    double sin = StrictMath.sin(box.psi());
    double half = 0.5 * box.length();
    double aside = 0.5 * box.width();
    float high = (float) box.height();
    for (int side = -1; side <= 1; side += 2) {
      float x = (float) (box.x() - side * aside * sin);
      float y = (float) (box.y() + side * aside * cos);
      float c = (float) cos;
      float s = (float) sin;
      if (!isSawhorse) {
        solids.add(
            new Board(
                x, y, c, s, (float) half, 0.0f, high, Reflectance.GREY, Reflectance.GREY, 0.0f));
        float endX = (float) (box.x() + side * half * cos);
        float endY = (float) (box.y() + side * half * sin);
        solids.add(
            new Board(endX, endY, -s, c, (float) aside, 0.0f, high, Reflectance.GREY, 0, 0.0f));
        continue;
      }
      for (int plank = 0; plank < 2; plank++) {
        float low = plank == 0 ? high - 0.25f : 0.3f * high;
        solids.add(
            new Board(
                x,
                y,
                c,
                s,
                (float) half,
                low,
                low + 0.25f,
                Reflectance.WHITE,
                Reflectance.ORANGE,
                0.15f));
      }
      for (int end = -1; end <= 1; end += 2) {
        double along = end * (half - LEG_M);
        solids.add(
            new Board(
                (float) (x + along * cos),
                (float) (y + along * sin),
                c,
                s,
                (float) LEG_M,
                0.0f,
                high - 0.25f,
                Reflectance.WOOD,
                0,
                0.0f));
      }
    }
  }
}
