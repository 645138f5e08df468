package org.u2sa.gcs.report;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;

/**
 * Writes {@code track.csv} (RFC 4180, with line feeds): one line a sample, units in the header,
 * fixed decimals, the same bytes everywhere.
 */
final class TrackCsv {

  private static final String HEADER =
      "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg,roll_deg,pitch_deg,calibrated_airspeed_mps,ground_speed_mps,cross_track_m,leg,on_ground,phase\n";

  private TrackCsv() {}

  static void write(Writer out, List<FlightSample> track) throws IOException {
    out.write(HEADER);
    for (FlightSample s : track) {
      out.write(
          String.format(
              Locale.ROOT,
              "%.3f,%.8f,%.8f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%d,%d,%s\n",
              s.timeS(),
              s.longitudeDeg(),
              s.latitudeDeg(),
              s.altitudeM(),
              Math.toDegrees(s.headingRad()),
              Math.toDegrees(s.rollRad()),
              Math.toDegrees(s.pitchRad()),
              s.calibratedAirspeedMps(),
              s.groundSpeedMps(),
              s.crossTrackM(),
              s.leg(),
              s.onGround() ? 1 : 0,
              quoted(s.phase())));
    }
  }

  private static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }
}
