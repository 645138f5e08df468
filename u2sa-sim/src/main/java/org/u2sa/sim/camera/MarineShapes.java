package org.u2sa.sim.camera;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Coloured;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;

/** Solids of objects at any height, on and under water. */
final class MarineShapes {
  private static final float MISS = Float.POSITIVE_INFINITY;
  private static final double[] NO_SHADOW = {};
  private static final double SHEET_M = 0.01; // thickness of flat objects
  private static final double RIM = 0.7; // inner part of a bin, as a fraction of its size

  private MarineShapes() {}

  /** Solids of an object in LOCAL_ENU; none if it has no volume. */
  static List<Solid> of(ObjectDescription object) {
    int colour = colour(object);
    List<Solid> solids = new ArrayList<>();
    if (object instanceof Sphere ball) {
      solids.add(new Ball(object.center(), (float) ball.radius(), colour));
    } else if (object instanceof Cylinder post) {
      solids.add(
          new Post(object.center(), (float) post.radius(), 0.5f * (float) post.height(), colour));
    } else if (object instanceof Hoop hoop) {
      solids.add(new Rim(hoop, (float) hoop.radius(), 0.5f * (float) hoop.thickness(), colour));
    } else if (object instanceof Dock dock) {
      dock.walls().forEach(wall -> solids.add(Slab.of(wall, colour)));
    } else if (object instanceof Bin bin) {
      solids.add(Slab.of(bin, Reflectance.WHITE));
      Point lid = bin.center().plus(Point.of(0.0, 0.0, 0.5 * bin.height()));
      Point inner = Point.of(RIM * bin.length(), RIM * bin.width(), SHEET_M);
      solids.add(Slab.of(lid, bin.psi(), inner, colour));
    } else if (object instanceof Box box) {
      solids.add(Slab.of(box, colour));
    } else if (object instanceof Rectangle flat) {
      Point size = Point.of(flat.length(), flat.width(), SHEET_M);
      solids.add(Slab.of(flat.center(), flat.psi(), size, colour));
    }
    return solids;
  }

  private static int colour(ObjectDescription object) {
    if (object instanceof Dock dock && dock.colour().isEmpty()) {
      return Reflectance.WOOD;
    }
    if (object instanceof HotTarget) {
      return Reflectance.STEEL;
    }
    return object instanceof Coloured painted
        ? painted.colour().map(Reflectance::of).orElse(Reflectance.GREY)
        : Reflectance.GREY;
  }

  /** A sphere. */
  record Ball(Point centre, float radius, int colour) implements Solid {
    @Override
    public float[] column() {
      return MarineShapes.column(centre, radius, radius);
    }

    @Override
    public float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch) {
      float px = x - (float) centre.x();
      float py = y - (float) centre.y();
      float pz = z - (float) centre.z();
      float a = dx * dx + dy * dy + dz * dz;
      float half = px * dx + py * dy + pz * dz;
      float left = half * half - a * (px * px + py * py + pz * pz - radius * radius);
      float hit = left < 0.0f ? -1.0f : (-half - (float) Math.sqrt(left)) / a;
      if (!(hit > 0.0f)) {
        return MISS;
      }
      touch.colour = colour;
      touch.nx = (px + hit * dx) / radius;
      touch.ny = (py + hit * dy) / radius;
      touch.nz = (pz + hit * dz) / radius;
      return hit;
    }

    @Override
    public double[] shadow(double sunX, double sunY, double sunZ) {
      return NO_SHADOW;
    }
  }

  /** An upright cylinder. */
  record Post(Point centre, float radius, float half, int colour) implements Solid {
    @Override
    public float[] column() {
      return MarineShapes.column(centre, radius, half);
    }

    @Override
    public float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch) {
      float px = x - (float) centre.x();
      float py = y - (float) centre.y();
      float pz = z - (float) centre.z();
      float a = dx * dx + dy * dy;
      float b = px * dx + py * dy;
      float left = b * b - a * (px * px + py * py - radius * radius);
      if (left > 0.0f) {
        float side = (-b - (float) Math.sqrt(left)) / a;
        if (side > 0.0f && Math.abs(pz + side * dz) <= half) {
          touch.colour = colour;
          touch.nx = (px + side * dx) / radius;
          touch.ny = (py + side * dy) / radius;
          touch.nz = 0.0f;
          return side;
        }
      }
      float lid = ((dz < 0.0f ? half : -half) - pz) / dz;
      float lx = px + lid * dx;
      float ly = py + lid * dy;
      if (!(lid > 0.0f) || lx * lx + ly * ly > radius * radius) {
        return MISS;
      }
      touch.colour = colour;
      touch.nx = 0.0f;
      touch.ny = 0.0f;
      touch.nz = dz < 0.0f ? 1.0f : -1.0f;
      return lid;
    }

    @Override
    public double[] shadow(double sunX, double sunY, double sunZ) {
      return NO_SHADOW;
    }
  }

  /** An upright box turned about the vertical. */
  record Slab(Point centre, float cos, float sin, float[] half, int colour) implements Solid {
    static Slab of(Box box, int colour) {
      Point size = Point.of(box.length(), box.width(), box.height());
      return of(box.center(), box.psi(), size, colour);
    }

    static Slab of(Point centre, double psi, Point size, int colour) {
      float[] half = {0.5f * (float) size.x(), 0.5f * (float) size.y(), 0.5f * (float) size.z()};
      return new Slab(
          centre, (float) StrictMath.cos(psi), (float) StrictMath.sin(psi), half, colour);
    }

    @Override
    public float[] column() {
      return MarineShapes.column(centre, (float) Math.hypot(half[0], half[1]), half[2]);
    }

    @Override
    public float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch) {
      float px = x - (float) centre.x();
      float py = y - (float) centre.y();
      float enter = 0.0f;
      float leave = MISS;
      int face = -1;
      for (int axis = 0; axis < 3; axis++) {
        float from =
            axis == 0
                ? px * cos + py * sin
                : axis == 1 ? py * cos - px * sin : z - (float) centre.z();
        float way = axis == 0 ? dx * cos + dy * sin : axis == 1 ? dy * cos - dx * sin : dz;
        if (way == 0.0f) {
          if (Math.abs(from) > half[axis]) {
            return MISS;
          }
          continue;
        }
        float first = (way > 0.0f ? -half[axis] - from : half[axis] - from) / way;
        leave = Math.min(leave, (way > 0.0f ? half[axis] - from : -half[axis] - from) / way);
        if (first > enter) {
          enter = first;
          face = way > 0.0f ? 2 * axis : 2 * axis + 1;
        }
      }
      if (face < 0 || enter > leave) {
        return MISS;
      }
      float side = (face & 1) == 0 ? -1.0f : 1.0f;
      touch.colour = colour;
      touch.nx = face < 2 ? side * cos : face < 4 ? -side * sin : 0.0f;
      touch.ny = face < 2 ? side * sin : face < 4 ? side * cos : 0.0f;
      touch.nz = face < 4 ? 0.0f : side;
      return enter;
    }

    @Override
    public double[] shadow(double sunX, double sunY, double sunZ) {
      return NO_SHADOW;
    }
  }

  /**
   * A hoop, as straight tubes. A tube thinner than a pixel covers only part of it, see {@link
   * Solid.Touch#cover}.
   */
  record Rim(Point centre, float radius, float half, List<Point> corners, int colour)
      implements Solid {
    private static final int SIDES = 32;

    Rim(Hoop hoop, float radius, float half, int colour) {
      this(hoop.center(), radius, half, hoop.outline(SIDES), colour);
    }

    @Override
    public float[] column() {
      return MarineShapes.column(centre, radius + half, radius + half);
    }

    @Override
    public float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch) {
      float best = MISS;
      float d2 = dx * dx + dy * dy + dz * dz;
      for (int i = 1; i < corners.size(); i++) {
        Point a = corners.get(i - 1);
        float ex = (float) (corners.get(i).x() - a.x());
        float ey = (float) (corners.get(i).y() - a.y());
        float ez = (float) (corners.get(i).z() - a.z());
        float wx = x - (float) a.x();
        float wy = y - (float) a.y();
        float wz = z - (float) a.z();
        float e2 = ex * ex + ey * ey + ez * ez;
        float de = dx * ex + dy * ey + dz * ez;
        float dw = dx * wx + dy * wy + dz * wz;
        float ew = ex * wx + ey * wy + ez * wz;
        float det = d2 * e2 - de * de;
        float s = det == 0.0f ? 0.0f : Math.max(0.0f, Math.min(1.0f, (d2 * ew - de * dw) / det));
        float t = (s * de - dw) / d2; // point of the ray nearest to the tube's axis
        float ox = wx + t * dx - s * ex;
        float oy = wy + t * dy - s * ey;
        float oz = wz + t * dz - s * ez;
        float off = ox * ox + oy * oy + oz * oz;
        float wide = Math.max(half, touch.pixel * t);
        if (t > 0.0f && t < best && off <= wide * wide) {
          best = t;
          float length = Math.max(1e-6f, (float) Math.sqrt(off));
          touch.colour = colour;
          touch.nx = ox / length;
          touch.ny = oy / length;
          touch.nz = oz / length;
          touch.cover = half / wide;
        }
      }
      return best;
    }

    @Override
    public double[] shadow(double sunX, double sunY, double sunZ) {
      return NO_SHADOW;
    }
  }

  private static float[] column(Point centre, float radius, float half) {
    return new float[] {(float) centre.x(), (float) centre.y(), (float) centre.z(), radius, half};
  }
}
