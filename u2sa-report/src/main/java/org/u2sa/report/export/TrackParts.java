package org.u2sa.report.export;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Cuts tracks at the antimeridian, as RFC 7946 (3.1.9) requires for lines, which would otherwise be
 * drawn around the world.
 */
final class TrackParts {
  private static final double HALF_TURN_DEG = 180.0;
  private static final double TURN_DEG = 360.0;

  private TrackParts() {}

  /**
   * Parts of a track; only one if it does not cross. Each part except the last ends on the
   * antimeridian, where the next one starts with the opposite sign.
   */
  static List<List<GeoRun.Fix>> of(List<GeoRun.Fix> track) {
    List<List<GeoRun.Fix>> parts = new ArrayList<>();
    List<GeoRun.Fix> part = new ArrayList<>();
    for (GeoRun.Fix fix : track) {
      GeoRun.Fix last = part.isEmpty() ? null : part.get(part.size() - 1);
      if (last != null && Math.abs(fix.longitudeDeg() - last.longitudeDeg()) > HALF_TURN_DEG) {
        double side = Math.copySign(HALF_TURN_DEG, last.longitudeDeg());
        double way = Math.IEEEremainder(fix.longitudeDeg() - last.longitudeDeg(), TURN_DEG);
        double share = way == 0.0 ? 0.0 : (side - last.longitudeDeg()) / way;
        part.add(between(last, fix, share, side));
        parts.add(part);
        part = new ArrayList<>();
        part.add(between(last, fix, share, -side));
      }
      part.add(fix);
    }
    parts.add(part);
    return parts;
  }

  private static GeoRun.Fix between(GeoRun.Fix a, GeoRun.Fix b, double share, double longitudeDeg) {
    return new GeoRun.Fix(
        a.nanos() + Math.round(share * (b.nanos() - a.nanos())),
        longitudeDeg,
        a.latitudeDeg() + share * (b.latitudeDeg() - a.latitudeDeg()),
        a.altitudeM().isPresent() && b.altitudeM().isPresent()
            ? OptionalDouble.of(
                a.altitudeM().getAsDouble()
                    + share * (b.altitudeM().getAsDouble() - a.altitudeM().getAsDouble()))
            : a.altitudeM());
  }
}
