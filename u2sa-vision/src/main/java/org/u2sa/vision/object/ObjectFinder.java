package org.u2sa.vision.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.BiPredicate;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.ground.GroundSigma;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.object.ColourPatches.ColourClass;
import org.u2sa.vision.object.ColourPatches.ColourPatch;

/**
 * Detects barrels, sawhorses and flags by colour and size, and locates them by the pixel where they
 * meet the ground and by their apparent size. Not thread-safe; reuses its buffers.
 */
public final class ObjectFinder {
  private static final double STRIPE = 1.8; // max. width of a plank's stripe, of its height
  private static final double WHITE_BAND = 0.75; // max. gap between two bands, of their width
  private static final double IN_LINE = 0.6; // min. overlap of a barrel's bands
  private static final double ALIKE_WIDE = 0.55; // min. width ratio of two bands
  private static final double EDGE_PX = 2.0; // error of a patch's edge
  private static final double SLIM = 0.55; // fraction of a barrel's width
  private static final double STOUT = 1.6;
  private static final double SQUAT = 0.7; // fraction of the width: a trestle is lower than wide
  private static final double SOLID = 0.53; // min. orange in a row of barrels; a trestle has less
  private static final double LOW = 0.35; // fraction of a barrel's height
  private static final double EDGE_M = 0.03; // error of an edge's height above the ground
  private static final double LARGEST_FLAG = 0.3; // fraction of the image height
  private static final double FLATTEST = 1e-3; // min. difference of two rays' slopes
  private static final int BORDER_PX = 3;

  private final ColourPatches patches = new ColourPatches();
  private final ObjectSettings settings;
  private final GroundSigma sigma;
  private final List<ColourPatch> hiding = new ArrayList<>(); // occluding patches in the last image

  /** Creates a detector for objects of these sizes and a camera of this uncertainty. */
  public ObjectFinder(ObjectSettings settings, GroundSigma sigma) {
    this.settings = settings;
    this.sigma = sigma;
  }

  /** Detects objects, nearest first; none in a greyscale image. */
  public List<SeenObject> find(CameraFrame frame, GroundView view) {
    List<ColourPatch> orange = new ArrayList<>();
    List<SeenObject> found = new ArrayList<>();
    hiding.clear();
    for (ColourPatch patch : patches.find(frame)) {
      if (patch.colour() == ColourClass.ORANGE) {
        orange.add(patch);
      } else if (patch.height() < LARGEST_FLAG * frame.height()) {
        hiding.add(withPole(patch));
        flag(patch, frame, view).ifPresent(found::add);
      }
    }
    for (ColourPatch patch : joined(orange)) {
      hiding.add(patch);
      for (ColourPatch each : apart(patch, frame, view)) {
        orange(each, frame, view).ifPresent(found::add);
      }
    }
    found.sort(Comparator.comparingDouble(object -> object.foot().distance()));
    return found;
  }

  /**
   * Marks the pixels of the last image that occlude the ground: orange areas with their white
   * bands, flags and flag poles. None of these is a painted line.
   *
   * @param into every second pixel of every second row, row-major
   * @param width image width [px]
   * @param height image height [px]
   */
  public void hide(boolean[] into, int width, int height) {
    int columns = (width + 1) / 2;
    int rows = (height + 1) / 2;
    Arrays.fill(into, 0, columns * rows, false);
    for (ColourPatch patch : hiding) {
      int more = 2 + patch.width() / 12; // allow for the white edge of a plank and lens blur
      int from = Math.max(0, (patch.left() - more) / 2);
      int to = Math.min(columns, (patch.right() + more) / 2 + 1);
      int bottom = Math.min(rows, (patch.bottom() + more) / 2 + 1);
      for (int row = Math.max(0, (patch.top() - more) / 2); row < bottom; row++) {
        Arrays.fill(into, row * columns + from, row * columns + to, true);
      }
    }
  }

  /** Merges the stripes of a plank, then the bands of a barrel and the planks of a trestle. */
  private static List<ColourPatch> joined(List<ColourPatch> single) {
    return joined(joined(single, ObjectFinder::areStripes), ObjectFinder::areBands);
  }

  private static List<ColourPatch> joined(
      List<ColourPatch> single, BiPredicate<ColourPatch, ColourPatch> belong) {
    List<ColourPatch> patches = new ArrayList<>(single);
    for (int i = 0; i < patches.size(); i++) {
      for (int k = 0; k < patches.size(); k++) {
        if (k != i && belong.test(patches.get(i), patches.get(k))) {
          patches.set(i, patches.get(i).with(patches.get(k)));
          patches.remove(k);
          i = k < i ? i - 1 : i;
          k = -1; // it grew: compare with all others again
        }
      }
    }
    return patches;
  }

  /** Whether these are slanted adjacent stripes, which overlap in columns. */
  private static boolean areStripes(ColourPatch a, ColourPatch b) {
    int high = Math.min(a.height(), b.height());
    int tall = Math.max(a.height(), b.height());
    int apart = Math.max(a.left(), b.left()) - Math.min(a.right(), b.right()) - 1;
    boolean isOneStripe = a.width() <= STRIPE * a.height() || b.width() <= STRIPE * b.height();
    return isOneStripe && apart <= 2 && -a.rowsBetween(b) >= 0.7 * high && high >= 0.6 * tall;
  }

  /** Whether these are stacked bands of similar width. */
  private static boolean areBands(ColourPatch a, ColourPatch b) {
    int wide = Math.max(a.width(), b.width());
    int narrow = Math.min(a.width(), b.width());
    return narrow >= ALIKE_WIDE * wide
        && a.overlap(b) >= IN_LINE
        && a.rowsBetween(b) <= WHITE_BAND * wide;
  }

  /** Splits a patch of adjacent barrels into single barrels. */
  private List<ColourPatch> apart(ColourPatch patch, CameraFrame frame, GroundView view) {
    double middle = 0.5 * (patch.left() + patch.right());
    RangeEstimate range = byEdge(patch, middle, settings.barrelBaseM(), 0.0, frame, view);
    double barrels =
        2.0 * range.range() * Math.tan(0.5 * viewRad(patch, view)) / settings.barrelWidthM();
    boolean isSolid = patch.count() >= SOLID * patch.width() * patch.height();
    if (!range.isKnown() || !isSolid || barrels < STOUT || patch.height() > patch.width()) {
      return List.of(patch);
    }
    int count = (int) Math.max(2, Math.round(barrels));
    List<ColourPatch> each = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      each.add(
          new ColourPatch(
              patch.colour(),
              patch.left() + i * patch.width() / count,
              patch.top(),
              patch.left() + (i + 1) * patch.width() / count - 1,
              patch.bottom(),
              patch.count() / count));
    }
    return each;
  }

  private Optional<SeenObject> orange(ColourPatch patch, CameraFrame frame, GroundView view) {
    double middle = 0.5 * (patch.left() + patch.right());
    double radius = 0.5 * settings.barrelWidthM();
    double viewRad = viewRad(patch, view);
    boolean isCut = isCut(patch, frame);
    RangeEstimate byFoot = byEdge(patch, middle, settings.barrelBaseM(), radius, frame, view);
    boolean isWhole = byFoot.isKnown() && patch.top() >= BORDER_PX;
    RangeEstimate byWidth =
        isCut ? RangeEstimate.UNKNOWN : bySize(2.0 * radius, viewRad, patch.width());
    double orangeM = settings.barrelHeightM() - settings.barrelBaseM();
    RangeEstimate bySize = isWhole ? byHeight(orangeM, patch, middle, view) : byWidth;
    RangeEstimate range = byFoot.with(bySize);
    if (!range.isKnown() || range.range() > settings.farthestM()) {
      return Optional.empty();
    }
    double widthM = 2.0 * (byFoot.isKnown() ? byFoot : range).range() * Math.tan(0.5 * viewRad);
    if (widthM > STOUT * 2.0 * radius && patch.height() < SQUAT * patch.width()) {
      return sawhorse(patch, middle, frame, view);
    }
    double heightM = widthM * patch.height() / patch.width();
    if (widthM < SLIM * 2.0 * radius && !isCut || heightM < LOW * settings.barrelHeightM()) {
      return Optional.empty();
    }
    double confidence = byFoot.agreesWith(bySize) ? 0.9 : 0.6;
    return place(
        ObjectKind.BARREL,
        patch,
        range,
        radius,
        settings.barrelHeightM(),
        confidence,
        middle,
        view);
  }

  private Optional<SeenObject> sawhorse(
      ColourPatch patch, double middle, CameraFrame frame, GroundView view) {
    RangeEstimate range = byEdge(patch, middle, settings.sawhorseClearM(), 0.0, frame, view);
    double widthM = 2.0 * range.range() * Math.tan(0.5 * viewRad(patch, view));
    if (!range.isKnown()
        || range.range() > settings.farthestM()
        || widthM > STOUT * settings.sawhorseWidthM()) {
      return Optional.empty();
    }
    return place(
        ObjectKind.SAWHORSE,
        patch,
        range,
        0.5 * Math.min(widthM, settings.sawhorseWidthM()),
        settings.barrelHeightM(),
        0.7,
        middle,
        view);
  }

  /** Marks a flag down to the ground: its pole is bright and thin like paint. */
  private ColourPatch withPole(ColourPatch cloth) {
    double down = cloth.height() * (settings.flagTopM() / settings.flagClothM() - 1.0);
    int side = cloth.width() / 3; // the pole may be on either side of the cloth
    return new ColourPatch(
        cloth.colour(),
        cloth.left() - side,
        cloth.top(),
        cloth.right() + side,
        cloth.bottom() + (int) Math.ceil(1.3 * down),
        cloth.count());
  }

  private Optional<SeenObject> flag(ColourPatch patch, CameraFrame frame, GroundView view) {
    double middle = 0.5 * (patch.left() + patch.right());
    double lowM = settings.flagTopM() - settings.flagClothM();
    double edge = EDGE_PX / view.lens().pinhole().focalY();
    Optional<Point> low = view.atHeight(middle, patch.bottom() + 0.5, lowM);
    Optional<Point> high = view.atHeight(middle, patch.top() - 0.5, settings.flagTopM());
    if (isCut(patch, frame) || patch.bottom() >= frame.height() - BORDER_PX || !low.isPresent()) {
      return Optional.empty();
    }
    Point camera = view.camera();
    double clearance = view.heightM() - lowM;
    double lowRange = low.get().flatDistanceTo(camera);
    RangeEstimate byLow =
        new RangeEstimate(
            lowRange,
            Math.hypot(edge, sigma.tiltRad())
                * (lowRange * lowRange + clearance * clearance)
                / Math.max(0.05, Math.abs(clearance)));
    RangeEstimate bySize = byHeight(settings.flagClothM(), patch, middle, view);
    RangeEstimate range = bySize.with(byLow);
    double wide = 2.0 * range.range() * Math.tan(0.5 * viewRad(patch, view));
    boolean isPlausible =
        bySize.agreesWith(byLow)
            && high.isPresent()
            && wide <= 1.5 * settings.flagWidthM()
            && range.range() <= settings.farthestM()
            && patch.count() >= 0.35 * patch.width() * patch.height();
    return isPlausible
        ? place(
            patch.colour() == ColourClass.RED ? ObjectKind.RED_FLAG : ObjectKind.BLUE_FLAG,
            patch,
            range,
            0.5 * settings.flagWidthM(),
            settings.flagTopM(),
            0.8,
            middle,
            view)
        : Optional.empty();
  }

  private Optional<SeenObject> place(
      ObjectKind kind,
      ColourPatch patch,
      RangeEstimate range,
      double radiusM,
      double heightM,
      double confidence,
      double middle,
      GroundView view) {
    double row = Math.max(patch.top(), patch.bottom());
    return view.ray(middle, row)
        .map(
            ray -> {
              double flat = Math.hypot(ray.x(), ray.y());
              Point camera = view.camera();
              Point foot =
                  view.onGround(
                      camera.x() + range.range() * ray.x() / flat,
                      camera.y() + range.range() * ray.y() / flat);
              double edges = EDGE_PX / view.lens().pinhole().focalX() * range.range();
              return new SeenObject(
                  kind,
                  foot,
                  radiusM,
                  heightM,
                  Math.hypot(range.sigma(), sigma.ownM()),
                  Math.hypot(sigma.acrossM(range.range()), edges),
                  confidence,
                  patch.left(),
                  patch.top(),
                  patch.right(),
                  patch.bottom());
            });
  }

  /**
   * Distance of the centre from the lower edge's pixel.
   *
   * @param edgeM height of that edge above the ground [m]
   * @param behindM distance of the centre behind the edge [m]
   */
  private RangeEstimate byEdge(
      ColourPatch patch,
      double middle,
      double edgeM,
      double behindM,
      CameraFrame frame,
      GroundView view) {
    if (patch.bottom() >= frame.height() - BORDER_PX) {
      return RangeEstimate.UNKNOWN; // extends below the image
    }
    double edgeRad = Math.hypot(EDGE_PX / view.lens().pinhole().focalY(), sigma.tiltRad());
    double clearance = Math.max(0.1, view.heightM() - edgeM);
    return view.atHeight(middle, patch.bottom() + 0.5, edgeM)
        .map(edge -> edge.flatDistanceTo(view.camera()))
        .map(
            range ->
                new RangeEstimate(
                    range + behindM,
                    Math.hypot(
                        edgeRad * (range * range + clearance * clearance) / clearance,
                        EDGE_M * range / clearance)))
        .orElse(RangeEstimate.UNKNOWN);
  }

  /** Distance by apparent height; off-axis barrels lean in the image but keep their height. */
  private static RangeEstimate byHeight(
      double heightM, ColourPatch patch, double middle, GroundView view) {
    Optional<Point> top = view.ray(middle, patch.top() - 0.5);
    Optional<Point> bottom = view.ray(middle, patch.bottom() + 0.5);
    if (!top.isPresent() || !bottom.isPresent()) {
      return RangeEstimate.UNKNOWN;
    }
    double drop = slope(bottom.get()) - slope(top.get());
    if (!(drop > FLATTEST)) {
      return RangeEstimate.UNKNOWN;
    }
    double range = heightM / drop;
    return new RangeEstimate(range, range * Math.hypot(EDGE_PX / patch.height(), 0.06));
  }

  /** Descent of a ray per metre. */
  private static double slope(Point ray) {
    return ray.z() / Math.max(FLATTEST, Math.hypot(ray.x(), ray.y()));
  }

  private static RangeEstimate bySize(double sizeM, double viewRad, int pixels) {
    double range = 0.5 * sizeM / Math.tan(0.5 * viewRad);
    return new RangeEstimate(range, range * Math.hypot(EDGE_PX / pixels, 0.08));
  }

  private static double viewRad(ColourPatch patch, GroundView view) {
    double row = 0.5 * (patch.top() + patch.bottom());
    Optional<Point> left = view.ray(patch.left() - 0.5, row);
    Optional<Point> right = view.ray(patch.right() + 0.5, row);
    if (!left.isPresent() || !right.isPresent()) {
      return patch.width() / view.lens().pinhole().focalX();
    }
    Point a = left.get();
    Point b = right.get();
    double cosine = (a.x() * b.x() + a.y() * b.y() + a.z() * b.z()) / (a.distance() * b.distance());
    return Math.acos(Math.max(-1.0, Math.min(1.0, cosine)));
  }

  private static boolean isCut(ColourPatch patch, CameraFrame frame) {
    return patch.left() < BORDER_PX || patch.right() >= frame.width() - BORDER_PX;
  }
}
