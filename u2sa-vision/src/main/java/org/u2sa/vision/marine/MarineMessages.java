package org.u2sa.vision.marine;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Bin;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Button;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.HotTarget;
import org.u2sa.messages.marine.PathMarker;
import org.u2sa.messages.marine.Pole;
import org.u2sa.vision.ground.CameraMount;

/** Converts the detections of one picture to Object Descriptions in BODY. */
final class MarineMessages {
  private final String sensorName;
  private final MarineVariables settings;
  private final CameraMount mount;
  private final double angleSigma;

  MarineMessages(
      String sensorName, MarineVariables settings, CameraMount mount, double angleSigma) {
    this.sensorName = sensorName;
    this.settings = settings;
    this.mount = mount;
    this.angleSigma = angleSigma;
  }

  /** Numbers the objects of each kind in one picture. */
  Map<MarineKind, Integer> numbers() {
    return new EnumMap<>(MarineKind.class);
  }

  ObjectDescription of(SeenThing thing, Map<MarineKind, Integer> numbers, long micros) {
    Point frd = mount.turn().times(thing.way());
    Point at = body(frd.times(thing.rangeM()).plus(mount.place()));
    double towards = Math.atan2(frd.y(), -frd.x()); // to the camera; BODY's y is left
    ObjectDescription object = shaped(thing, at, towards);
    int number = numbers.merge(thing.kind(), 1, Integer::sum);
    String colour = thing.colour().map(c -> c.name().toLowerCase(Locale.ROOT) + " ").orElse("");
    object
        .uid(sensorName + " " + thing.kind().typeName() + " " + number)
        .objectType(colour + thing.kind().typeName())
        .referenceFrame(ReferenceFrame.BODY)
        .confidence(thing.confidence())
        .sensorName(sensorName);
    object.x(at.x()).y(at.y()).z(at.z());
    object.motion().sigma(sigma(frd, thing));
    object.timestamp(micros);
    return object;
  }

  private ObjectDescription shaped(SeenThing thing, Point at, double towards) {
    Optional<Colour> paint = thing.colour();
    return switch (thing.kind()) {
      case BUOY -> {
        Buoy buoy = new Buoy().radius(settings.buoyRadius());
        paint.ifPresent(buoy::colour);
        yield buoy;
      }
      case POLE -> {
        Pole pole = new Pole().height(settings.poleHeight());
        paint.ifPresent(pole::colour);
        yield pole;
      }
      case HOOP -> {
        Hoop hoop = new Hoop().radius(settings.hoopRadius()).psi(towards);
        paint.ifPresent(hoop::colour);
        yield hoop;
      }
      case BUTTON -> {
        double size = settings.buttonSize();
        Button button = new Button().width(size).height(size).psi(towards);
        paint.ifPresent(button::colour);
        yield button;
      }
      case DOCK -> {
        Dock dock = new Dock().width(settings.dockWidth()).psi(towards);
        paint.ifPresent(dock::colour);
        yield dock;
      }
      case BIN -> {
        Bin bin = new Bin().length(settings.binLength()).width(settings.binWidth());
        bin.psi(axis(thing, at));
        paint.ifPresent(bin::colour);
        yield bin;
      }
      case PATH_MARKER -> {
        PathMarker marker = new PathMarker().length(settings.markerLength());
        marker.width(settings.markerWidth()).psi(axis(thing, at));
        paint.ifPresent(marker::colour);
        yield marker;
      }
      case HOT_TARGET -> new HotTarget().psi(towards);
    };
  }

  /** Direction of the long axis in BODY, within ±π/2 of the vehicle's nose. */
  private double axis(SeenThing thing, Point at) {
    if (thing.axisEnd().isEmpty()) {
      return 0.0;
    }
    Point way = mount.turn().times(thing.axisEnd().get());
    double down = mount.turn().times(thing.way()).z() * thing.rangeM();
    Point end = body(way.times(down / way.z()).plus(mount.place())); // assuming level ground
    double psi = Math.atan2(end.y() - at.y(), end.x() - at.x());
    return Math.cos(psi) < 0.0 ? Math.atan2(at.y() - end.y(), at.x() - end.x()) : psi;
  }

  /** Standard deviations along BODY's axes, from the errors of range and direction. */
  private Point sigma(Point frd, SeenThing thing) {
    double across = angleSigma * thing.rangeM();
    return Point.of(
        mixed(frd.x(), thing.rangeSigmaM(), across),
        mixed(frd.y(), thing.rangeSigmaM(), across),
        mixed(frd.z(), thing.rangeSigmaM(), across));
  }

  private static double mixed(double share, double along, double across) {
    return Math.sqrt(
        share * share * along * along + Math.max(0.0, 1.0 - share * share) * across * across);
  }

  private static Point body(Point frd) {
    return Point.of(frd.x(), -frd.y(), frd.z());
  }
}
