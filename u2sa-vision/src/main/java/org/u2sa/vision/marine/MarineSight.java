package org.u2sa.vision.marine;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.messages.marine.Colour;
import org.u2sa.vision.ground.CameraMount;
import org.u2sa.vision.lens.LensCalibration;

/**
 * Detects objects by colour and shape, and their distance by their apparent size, which needs
 * neither ground nor attitude. Under water it removes veil and attenuation for that distance before
 * identifying a colour (Akkaynak and Treibitz 2018). Not thread-safe; reuses its buffers.
 */
final class MarineSight {
  private static final double STEEP = 0.5; // minimum downward component of a direction to a floor
  private static final double SQUARE = 0.88; // fill of a rectangle; a disc has 0.79
  private static final double FLAT = 0.93; // fill of a rectangle's upper part
  private static final double SPARSE = 0.62; // fill of anything round
  private static final double SLIM = 3.0; // elongation of poles and path markers
  private static final double FULL = 150.0; // cells for full confidence
  private static final int PLAIN = 30; // min. cells of a white or black buoy among waves
  private static final double REACH = 3.0; // standard deviations
  private static final Set<MarineKind> ON_FLOOR =
      EnumSet.of(MarineKind.BIN, MarineKind.PATH_MARKER);

  private final MarineVariables settings;
  private final CameraMount mount;
  private final Rotation frdFromCamera;
  private final LinearPicture picture = new LinearPicture();
  private final Segments segments = new Segments(picture);

  MarineSight(MarineVariables settings, CameraMount mount) {
    this.settings = settings;
    this.mount = mount;
    frdFromCamera = mount.turn();
  }

  /**
   * Objects of the given kinds in a colour picture.
   *
   * @param level rotation from the vehicle's FRD axes to level ones
   */
  List<SeenThing> look(
      CameraFrame frame, LensCalibration lens, Rotation level, Set<MarineKind> kinds) {
    List<SeenThing> seen = new ArrayList<>();
    if (frame.format() != CameraFrame.PixelFormat.RGB24 || kinds.isEmpty()) {
      return seen;
    }
    picture.read(frame);
    List<Segment> all = segments.find(settings.underWater(), kinds.contains(MarineKind.HOOP));
    for (Segment segment : all) {
      boolean isWhole = !segment.touchesBorder(picture.width, picture.height);
      if (isWhole && (settings.underWater() || !isReflected(segment, all))) {
        way(lens, segment.x(), segment.y())
            .flatMap(way -> kind(segment, way, kinds).flatMap(kind -> seen(kind, segment, lens)))
            .filter(thing -> floats(thing, level))
            .ifPresent(seen::add);
      }
    }
    return seen;
  }

  /** Whether an object of the same colour and at least 0.7 of its width is above it. */
  private static boolean isReflected(Segment segment, List<Segment> all) {
    for (Segment other : all) {
      int common =
          Math.min(segment.right(), other.right()) - Math.max(segment.left(), other.left());
      if (other != segment
          && other.paint() == segment.paint()
          && other.bottom() <= segment.top() + 1
          && segment.top() - other.bottom() < 4 * other.height()
          && other.width() >= 0.7 * segment.width()
          && common > 0.5 * segment.width()) {
        return true;
      }
    }
    return false;
  }

  /** Whether a buoy's direction agrees with its distance on the water. */
  private boolean floats(SeenThing thing, Rotation level) {
    double below = settings.heightAboveWater() - level.times(mount.place()).z();
    if (settings.underWater() || settings.heightAboveWater() == 0.0) {
      return true;
    }
    if (thing.kind() != MarineKind.BUOY) {
      return true;
    }
    double down = level.times(frdFromCamera.times(thing.way())).z();
    double expected = below / thing.rangeM();
    double own = expected * thing.rangeSigmaM() / thing.rangeM();
    double sigma =
        Math.hypot(Math.hypot(settings.tiltSigma(), own), settings.buoyRadius() / thing.rangeM());
    return Math.abs(down - expected) < REACH * sigma;
  }

  private Optional<MarineKind> kind(Segment s, Point way, Set<MarineKind> kinds) {
    boolean isFloor = frdFromCamera.times(way).z() > STEEP;
    for (MarineKind kind : kinds) {
      if (ON_FLOOR.contains(kind) == isFloor && fits(kind, s)) {
        return Optional.of(kind);
      }
    }
    return Optional.empty();
  }

  private boolean fits(MarineKind kind, Segment s) {
    double aspect = s.width() / (double) s.height();
    return switch (kind) {
      case BUOY -> settings.underWater() ? isBall(s, aspect) : isDome(s, aspect);
      case POLE -> !s.isOpen() && s.elongation() > SLIM && s.height() > 2 * s.width();
      case HOOP -> s.isOpen() && aspect > 0.3 && aspect < 1.4 && s.fill() < SPARSE;
      case BUTTON -> !s.isOpen() && aspect > 0.3 && aspect < 1.7 && s.fill() >= SQUARE;
      case DOCK -> !s.isOpen() && aspect >= 2.2 && s.width() > 12;
      case BIN -> s.elongation() < SLIM && s.count() > 40;
      case PATH_MARKER -> s.elongation() >= SLIM && s.count() > 25;
      case HOT_TARGET -> false;
    };
  }

  private static boolean isBall(Segment s, double aspect) {
    return !s.isOpen() && aspect > 0.7 && aspect < 1.45 && s.fill() > SPARSE && s.fill() < SQUARE;
  }

  /** Detects a ball on the water of which at least a third is visible. */
  private static boolean isDome(Segment s, double aspect) {
    boolean isPlain =
        s.paint() == Colour.WHITE.ordinal() + 1 || s.paint() == Colour.BLACK.ordinal() + 1;
    return s.dome().height() > 0.33 * s.dome().width()
        && s.dome().fill() > SPARSE
        && s.dome().fill() < FLAT
        && (!isPlain || s.count() >= PLAIN && s.fill() > SPARSE && aspect > 0.7 && aspect < 2.2);
  }

  /** Estimates the distance from the size, then the colour at that distance. */
  private Optional<SeenThing> seen(MarineKind kind, Segment s, LensCalibration lens) {
    double x = s.x();
    double y = s.y();
    double sizeM;
    double cells;
    double dx = 1.0; // direction in which the size is measured
    double dy = 0.0;
    switch (kind) {
      case BUOY -> {
        sizeM = 2.0 * settings.buoyRadius();
        cells = s.dome().width();
        x = s.dome().middle();
        y = settings.underWater() ? y : s.dome().row();
      }
      case DOCK -> {
        sizeM = settings.dockWidth();
        cells = s.width();
      }
      case BIN -> {
        sizeM = Math.sqrt(settings.binLength() * settings.binWidth());
        cells = Math.sqrt(Math.max(1.0, segments.likeMiddle(s, segments.middle(s))));
      }
      case PATH_MARKER -> {
        sizeM = settings.markerLength();
        cells = Math.sqrt(12.0) * s.major(); // a uniform bar of length l has l²/12
        dx = Math.cos(s.turn());
        dy = Math.sin(s.turn());
      }
      default -> {
        sizeM =
            kind == MarineKind.HOOP
                ? 2.0 * settings.hoopRadius()
                : kind == MarineKind.POLE ? settings.poleHeight() : settings.buttonSize();
        cells = s.height();
        x = 0.5 * (s.left() + s.right());
        y = 0.5 * (s.top() + s.bottom());
        dx = 0.0;
        dy = 1.0;
      }
    }
    Optional<Point> middle = way(lens, x, y);
    Optional<Point> first = way(lens, x - 0.5 * cells * dx, y - 0.5 * cells * dy);
    Optional<Point> last = way(lens, x + 0.5 * cells * dx, y + 0.5 * cells * dy);
    if (middle.isEmpty() || first.isEmpty() || last.isEmpty()) {
      return Optional.empty();
    }
    double angle = 2.0 * Math.asin(0.5 * first.get().distanceTo(last.get()));
    double half = 0.5 * angle;
    double range = 0.5 * sizeM / (kind == MarineKind.BUOY ? Math.sin(half) : Math.tan(half));
    double sigma = range * Math.hypot(settings.sizeSigma(), settings.pixelSigma() / (2.0 * cells));
    if (!(range <= settings.maxDistance())) {
      return Optional.empty();
    }
    boolean isFloor = ON_FLOOR.contains(kind);
    Optional<Colour> colour =
        s.paint() > 0
            ? Optional.of(Colour.values()[s.paint() - 1])
            : colour(kind == MarineKind.BIN ? segments.middle(s) : s.colour(), s, range, isFloor);
    if (isFloor && colour.isEmpty()) {
      return Optional.empty(); // light and shade on the floor
    }
    double confidence = 0.5 + 0.45 * Math.min(1.0, s.count() / FULL);
    return Optional.of(
        new SeenThing(
            kind,
            colour,
            middle.get(),
            range,
            sigma,
            isFloor ? end(lens, s) : Optional.empty(),
            confidence));
  }

  private static Optional<Point> end(LensCalibration lens, Segment s) {
    double half = 0.5 * Math.sqrt(12.0) * s.major();
    return way(lens, s.x() + half * Math.cos(s.turn()), s.y() + half * Math.sin(s.turn()));
  }

  /**
   * Colour under water: the signal is J e^(-c r) + B (1 - e^(-c r)), and the light that colours J
   * is that of the veil B times c, since water scatters all colours alike. A floor, which is grey,
   * serves as the white reference instead.
   */
  private Optional<Colour> colour(double[] mean, Segment s, double range, boolean isFloor) {
    double[] attenuation = settings.attenuation();
    double[] own = new double[3];
    double bright = 0.0;
    for (int hue = 0; hue < 3; hue++) {
      double back = s.around()[hue];
      double clear = Math.exp(attenuation[hue] * range);
      own[hue] =
          isFloor || !settings.underWater()
              ? mean[hue] / (settings.underWater() ? back : 1.0)
              : Math.max(0.0, (mean[hue] - back) * clear + back) / (back * attenuation[hue]);
      bright += mean[hue] / back / 3.0;
    }
    return Paints.name(own[0], own[1], own[2], bright);
  }

  /** Direction to a position in cells; a cell's centre lies between its pixels. */
  private static Optional<Point> way(LensCalibration lens, double column, double row) {
    return wayOfPixel(lens, 2.0 * column + 0.5, 2.0 * row + 0.5);
  }

  /** Unit vector to a position in the picture [px], in camera axes. */
  static Optional<Point> wayOfPixel(LensCalibration lens, double column, double row) {
    return lens.place(column, row)
        .map(
            spot -> {
              double length = Math.sqrt(1.0 + spot.x() * spot.x() + spot.y() * spot.y());
              return Point.of(1.0 / length, spot.x() / length, spot.y() / length);
            });
  }
}
