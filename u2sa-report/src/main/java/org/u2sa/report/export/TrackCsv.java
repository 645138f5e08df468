package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.TrackSample;

/**
 * Writes {@code track.csv} (RFC 4180, with line feeds): one line per sample, units in the header,
 * fixed decimals; an absent value is an empty field. Output is byte-identical on every platform.
 */
public final class TrackCsv {

  private static final String FLIGHT_HEADER =
      "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg,roll_deg,pitch_deg,calibrated_airspeed_mps,ground_speed_mps,cross_track_m,leg,on_ground,phase\n";
  private static final String HEADER =
      "time_s,longitude_deg,latitude_deg,altitude_m,heading_deg,ground_speed_mps,cross_track_m,leg,phase\n";

  private TrackCsv() {}

  public static void write(Writer out, Domain domain, List<TrackSample> track) throws IOException {
    out.write(domain == Domain.AIR ? FLIGHT_HEADER : HEADER);
    for (TrackSample s : track) {
      append(out, domain, s);
    }
  }

  /** Writes one line, for a track that is written while it grows. */
  public static void append(Writer out, Domain domain, TrackSample sample) throws IOException {
    out.write(domain == Domain.AIR ? ofFlight(sample) : of(sample));
  }

  private static String of(TrackSample s) {
    return String.format(
        Locale.ROOT,
        "%.3f,%.8f,%.8f,%.3f,%.3f,%.3f,%s,%d,%s\n",
        s.timeS(),
        s.longitudeDeg(),
        s.latitudeDeg(),
        s.altitudeM(),
        Math.toDegrees(s.headingRad()),
        s.groundSpeedMps(),
        metres(s.crossTrackM()),
        s.leg(),
        CsvColumns.cell(s.phase()));
  }

  private static String ofFlight(TrackSample s) {
    TrackSample.Flight flight = s.flight().orElseThrow();
    return String.format(
        Locale.ROOT,
        "%.3f,%.8f,%.8f,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f,%s,%d,%d,%s\n",
        s.timeS(),
        s.longitudeDeg(),
        s.latitudeDeg(),
        s.altitudeM(),
        Math.toDegrees(s.headingRad()),
        Math.toDegrees(flight.rollRad()),
        Math.toDegrees(flight.pitchRad()),
        flight.calibratedAirspeedMps(),
        s.groundSpeedMps(),
        metres(s.crossTrackM()),
        s.leg(),
        flight.onGround() ? 1 : 0,
        CsvColumns.cell(s.phase()));
  }

  private static String metres(OptionalDouble value) {
    return value.isPresent() ? String.format(Locale.ROOT, "%.3f", value.getAsDouble()) : "";
  }
}
