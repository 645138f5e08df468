package org.u2sa.vision.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.ground.GroundView;

/**
 * Pictures with a known truth: grass, paint and upright things on a level ground, drawn pixel by
 * pixel with two rays each. Places are LEVEL.
 */
public final class PaintedScene {
  private static final int[] GRASS = {88, 112, 62};

  private final List<Patch> ground = new ArrayList<>();
  private final List<Upright> uprights = new ArrayList<>();
  private double light = 1.0;
  private double noise;
  private boolean grey;

  /** Changes the colour of ground. */
  private interface Patch {
    int[] colour(double x, double y, int[] before);
  }

  /** An upright cylinder with colours by height. */
  private record Upright(double x, double y, double radius, double height, Bands bands) {}

  /** The colour at a height and angle; null where one looks through. */
  public interface Bands {
    int[] colour(double z, double side);
  }

  /** A painted line between two places. */
  public PaintedScene line(Point from, Point to, double widthM, double paint) {
    ground.add(
        (x, y, before) -> {
          double alongX = to.x() - from.x();
          double alongY = to.y() - from.y();
          double share =
              ((x - from.x()) * alongX + (y - from.y()) * alongY)
                  / (alongX * alongX + alongY * alongY);
          double near = Math.max(0.0, Math.min(1.0, share));
          double off = Math.hypot(x - from.x() - near * alongX, y - from.y() - near * alongY);
          return off <= 0.5 * widthM ? mixed(before, new int[] {228, 230, 226}, paint) : before;
        });
    return this;
  }

  /** A disc of paint. */
  public PaintedScene disc(Point centre, double radiusM) {
    ground.add(
        (x, y, before) ->
            Math.hypot(x - centre.x(), y - centre.y()) <= radiusM
                ? new int[] {228, 230, 226}
                : before);
    return this;
  }

  /** Ground beyond a distance forward in light or shade: a factor of its brightness. */
  public PaintedScene shade(double fromX, double toX, double factor) {
    ground.add(
        (x, y, before) ->
            x >= fromX && x < toX
                ? new int[] {
                  (int) (factor * before[0]), (int) (factor * before[1]), (int) (factor * before[2])
                }
                : before);
    return this;
  }

  /** A strip of sunlight in the shade, as wide as a line. */
  public PaintedScene sunStrip(double y0, double widthM, double factor) {
    ground.add(
        (x, y, before) ->
            Math.abs(y - y0) <= 0.5 * widthM
                ? before
                : new int[] {
                  (int) (factor * before[0]), (int) (factor * before[1]), (int) (factor * before[2])
                });
    return this;
  }

  /** Something that stands on the ground. */
  public PaintedScene upright(Point foot, double radiusM, double heightM, Bands bands) {
    uprights.add(new Upright(foot.x(), foot.y(), radiusM, heightM, bands));
    return this;
  }

  /** An orange barrel with two white bands and a black foot. */
  public PaintedScene barrel(Point foot) {
    return upright(
        foot,
        0.3,
        1.0,
        (z, side) ->
            z < 0.08
                ? new int[] {40, 40, 40}
                : z % 0.33 > 0.2 ? new int[] {230, 230, 230} : new int[] {235, 112, 40});
  }

  /** Exposure: a factor of all brightness. */
  public PaintedScene light(double factor) {
    light = factor;
    return this;
  }

  /** Noise of each pixel, standard deviation of 255. */
  public PaintedScene noise(double sigma) {
    noise = sigma;
    return this;
  }

  /** Without colours. */
  public PaintedScene grey() {
    grey = true;
    return this;
  }

  /** The picture that a camera takes. */
  public CameraFrame picture(GroundView view, long seed) {
    int width = view.lens().width();
    int height = view.lens().height();
    Random random = new Random(seed);
    byte[] pixels = new byte[(grey ? 1 : 3) * width * height];
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        double[] sum = new double[3];
        for (int part = 0; part < 2; part++) {
          int[] colour = colour(view, column - 0.25 + 0.5 * part, row - 0.25 + 0.5 * part);
          for (int k = 0; k < 3; k++) {
            sum[k] += 0.5 * colour[k];
          }
        }
        int at = row * width + column;
        if (grey) {
          double bright = 0.3 * sum[0] + 0.59 * sum[1] + 0.11 * sum[2];
          pixels[at] = exposed(bright, random);
        } else {
          for (int k = 0; k < 3; k++) {
            pixels[3 * at + k] = exposed(sum[k], random);
          }
        }
      }
    }
    return new CameraFrame(
        0,
        width,
        height,
        grey ? PixelFormat.GREY8 : PixelFormat.RGB24,
        pixels,
        Optional.of(view.lens().pinhole()));
  }

  private byte exposed(double value, Random random) {
    return (byte)
        Math.round(Math.max(0.0, Math.min(255.0, light * value + noise * random.nextGaussian())));
  }

  private int[] colour(GroundView view, double column, double row) {
    Optional<Point> ray = view.ray(column, row);
    if (!ray.isPresent()) {
      return new int[] {0, 0, 0};
    }
    Optional<Point> foot = view.ground(column, row);
    double far = foot.map(place -> place.distanceTo(view.camera())).orElse(1e9);
    int[] seen = foot.map(this::onGround).orElse(new int[] {190, 205, 230});
    for (Upright upright : uprights) {
      int[] hit = hit(upright, view.camera(), ray.get(), far);
      if (hit != null) {
        seen = hit;
        far = hitDistance(upright, view.camera(), ray.get());
      }
    }
    return seen;
  }

  private int[] onGround(Point place) {
    // Blades of grass: a pattern that is the same in each picture, about 3 cm wide.
    long hash = (long) Math.floor(place.x() / 0.03) * 73_856_093L;
    hash ^= (long) Math.floor(place.y() / 0.03) * 19_349_663L;
    hash = hash * 0x9E3779B97F4A7C15L >>> 40;
    double rough = 0.85 + 0.3 * (hash & 0xFF) / 255.0;
    int[] colour = {(int) (rough * GRASS[0]), (int) (rough * GRASS[1]), (int) (rough * GRASS[2])};
    for (Patch patch : ground) {
      colour = patch.colour(place.x(), place.y(), colour);
    }
    return colour;
  }

  private static double hitDistance(Upright upright, Point from, Point ray) {
    double x = from.x() - upright.x();
    double y = from.y() - upright.y();
    double a = ray.x() * ray.x() + ray.y() * ray.y();
    double b = x * ray.x() + y * ray.y();
    double c = x * x + y * y - upright.radius() * upright.radius();
    double root = b * b - a * c;
    return root <= 0.0 ? -1.0 : (-b - Math.sqrt(root)) / a * ray.distance();
  }

  private static int[] hit(Upright upright, Point from, Point ray, double nearer) {
    double distance = hitDistance(upright, from, ray);
    if (distance <= 0.0 || distance >= nearer) {
      return null;
    }
    double t = distance / ray.distance();
    double z = -(from.z() + t * ray.z());
    double side = Math.atan2(from.y() + t * ray.y() - upright.y(), from.x() - upright.x());
    return z < 0.0 || z > upright.height() ? null : upright.bands().colour(z, side);
  }

  private static int[] mixed(int[] before, int[] paint, double share) {
    int[] mixed = new int[3];
    for (int k = 0; k < 3; k++) {
      mixed[k] = (int) Math.round(before[k] + share * (paint[k] - before[k]));
    }
    return mixed;
  }
}
