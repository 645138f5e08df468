package org.u2sa.vision.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.CameraFrame;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.ground.GroundSigma;
import org.u2sa.vision.ground.GroundView;

/**
 * Recognises barrels, sawhorses and flags by colour and size, and finds out where they stand: by
 * the pixel at which they meet the ground, and by how large they look. For one thread; reuses its
 * memory.
 */
public final class ObjectFinder {
  private static final double STRIPE = 0.75; // widest white stripe, of the patches' width
  private static final double IN_LINE = 0.6; // overlap of the bands of one barrel
  private static final double EDGE_PX = 2.0; // error of a patch's edge
  private static final double SLIM = 0.55; // of a barrel's width
  private static final double STOUT = 1.6;
  private static final int BORDER_PX = 3;

  private final ColourPatches patches = new ColourPatches();
  private final ObjectSettings settings;
  private final GroundSigma sigma;
  private List<ColourPatch> hiding = List.of(); // of the picture last looked at

  /** For things of these sizes, with a camera as uncertain as this. */
  public ObjectFinder(ObjectSettings settings, GroundSigma sigma) {
    this.settings = settings;
    this.sigma = sigma;
  }

  /** What is seen, nearest first; nothing in a picture without colours. */
  public List<SeenObject> find(CameraFrame frame, GroundView view) {
    List<ColourPatch> orange = new ArrayList<>();
    List<SeenObject> found = new ArrayList<>();
    for (ColourPatch patch : patches.find(frame)) {
      if (patch.colour() == ColourClass.ORANGE) {
        orange.add(patch);
      } else {
        flag(patch, frame, view).ifPresent(found::add);
      }
    }
    hiding = joined(orange);
    for (ColourPatch patch : hiding) {
      orange(patch, frame, view).ifPresent(found::add);
    }
    found.sort(Comparator.comparingDouble(object -> object.foot().distance()));
    return found;
  }

  /**
   * Marks the pixels behind which the ground is not seen, in the picture last looked at: what is
   * orange, and the white bands within, which are no painted lines.
   *
   * @param into every second pixel of every second row, row by row
   * @param width pixels of the picture's rows
   * @param height its rows
   */
  public void hide(boolean[] into, int width, int height) {
    int columns = (width + 1) / 2;
    int rows = (height + 1) / 2;
    Arrays.fill(into, 0, columns * rows, false);
    for (ColourPatch patch : hiding) {
      int more = 2 + patch.width() / 12; // the white edge of a plank, the blur of the lens
      int from = Math.max(0, (patch.left() - more) / 2);
      int to = Math.min(columns, (patch.right() + more) / 2 + 1);
      int bottom = Math.min(rows, (patch.bottom() + more) / 2 + 1);
      for (int row = Math.max(0, (patch.top() - more) / 2); row < bottom; row++) {
        Arrays.fill(into, row * columns + from, row * columns + to, true);
      }
    }
  }

  /** Bands of one barrel, and stripes of one plank, as one patch. */
  private static List<ColourPatch> joined(List<ColourPatch> single) {
    List<ColourPatch> patches = new ArrayList<>(single);
    boolean hasChanged = true;
    while (hasChanged) {
      hasChanged = false;
      for (int i = 0; i < patches.size(); i++) {
        for (int k = patches.size() - 1; k > i; k--) {
          if (belong(patches.get(i), patches.get(k))) {
            patches.set(i, patches.get(i).with(patches.remove(k)));
            hasChanged = true;
          }
        }
      }
    }
    return patches;
  }

  private static boolean belong(ColourPatch a, ColourPatch b) {
    int widest = Math.max(a.width(), b.width());
    int narrowest = Math.min(a.width(), b.width());
    if (a.overlap(b) >= IN_LINE && a.rowsBetween(b) <= STRIPE * widest) {
      return narrowest >= 0.5 * widest || a.rowsBetween(b) <= 0.3 * widest;
    }
    int between = Math.max(a.left(), b.left()) - Math.min(a.right(), b.right()) - 1;
    boolean sideBySide = a.rowsBetween(b) < 0 && between <= Math.max(6, 1.2 * narrowest);
    boolean alikeHigh = Math.min(a.height(), b.height()) >= 0.5 * Math.max(a.height(), b.height());
    return sideBySide && alikeHigh && isStripe(a) && isStripe(b);
  }

  /** Much smaller than what a barrel's band looks like beside it: as wide as high, or narrower. */
  private static boolean isStripe(ColourPatch patch) {
    return patch.width() <= 2.0 * patch.height();
  }

  private Optional<SeenObject> orange(ColourPatch patch, CameraFrame frame, GroundView view) {
    double middle = 0.5 * (patch.left() + patch.right());
    RangeEstimate byFoot = byFoot(patch, middle, frame, view);
    double viewRad = viewRad(patch, view);
    boolean isCut = isCut(patch, frame);
    RangeEstimate byWidth =
        isCut ? RangeEstimate.UNKNOWN : bySize(settings.barrelWidthM(), viewRad, patch.width());
    RangeEstimate asBarrel = byFoot.with(byWidth);
    if (!asBarrel.isKnown() || asBarrel.range() > settings.farthestM()) {
      return Optional.empty();
    }
    double widthM = 2.0 * asBarrel.range() * Math.tan(0.5 * viewRad);
    double heightM = widthM * patch.height() / patch.width();
    double barrel = settings.barrelWidthM();
    boolean isSlim = widthM < SLIM * barrel && !isCut;
    boolean isSquat = patch.height() < 0.7 * patch.width();
    if (byFoot.isKnown() && widthM > STOUT * barrel && isSquat) {
      return sawhorse(patch, byFoot, widthM, middle, frame, view);
    }
    if (isSlim || heightM < 0.35 * settings.barrelHeightM()) {
      return Optional.empty();
    }
    double centre = asBarrel.range() + (byFoot.isKnown() ? 0.5 * barrel : 0.0);
    return place(
        ObjectKind.BARREL,
        patch,
        new RangeEstimate(centre, asBarrel.sigma()),
        0.5 * barrel,
        settings.barrelHeightM(),
        byFoot.agreesWith(byWidth) ? 0.9 : 0.6,
        middle,
        view);
  }

  private Optional<SeenObject> sawhorse(
      ColourPatch patch,
      RangeEstimate byFoot,
      double widthM,
      double middle,
      CameraFrame frame,
      GroundView view) {
    // Its lower plank hangs above the ground: what is seen of orange ends there, not at the feet.
    RangeEstimate bySize =
        isCut(patch, frame)
            ? RangeEstimate.UNKNOWN
            : new RangeEstimate(
                byFoot.range() * settings.sawhorseWidthM() / widthM, 0.3 * byFoot.range());
    RangeEstimate range = byFoot.with(bySize);
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
    double lowRange = range(low.get(), camera);
    RangeEstimate byLow =
        new RangeEstimate(
            lowRange,
            Math.hypot(edge, sigma.tiltRad())
                * (lowRange * lowRange + clearance * clearance)
                / Math.max(0.05, Math.abs(clearance)));
    double viewRad = patch.height() / view.lens().pinhole().focalY();
    RangeEstimate bySize = bySize(settings.flagClothM(), viewRad, patch.height());
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

  /** The distance of the ground at its lower edge. */
  private RangeEstimate byFoot(
      ColourPatch patch, double middle, CameraFrame frame, GroundView view) {
    if (patch.bottom() >= frame.height() - BORDER_PX) {
      return RangeEstimate.UNKNOWN; // it goes on below the picture
    }
    return view.ground(middle, patch.bottom() + 0.5)
        .map(foot -> range(foot, view.camera()))
        .map(range -> new RangeEstimate(range, footSigma(range, view)))
        .orElse(RangeEstimate.UNKNOWN);
  }

  private double footSigma(double range, GroundView view) {
    double edge = EDGE_PX / view.lens().pinhole().focalY();
    double height = view.heightM();
    return Math.hypot(edge, sigma.tiltRad()) * (range * range + height * height) / height;
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

  private static double range(Point level, Point camera) {
    return Math.hypot(level.x() - camera.x(), level.y() - camera.y());
  }

  private static boolean isCut(ColourPatch patch, CameraFrame frame) {
    return patch.left() < BORDER_PX || patch.right() >= frame.width() - BORDER_PX;
  }
}
