package org.u2sa.drivers.radar;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;
import org.u2sa.interfaces.time.Clock;

/**
 * A marine radar that sends its tracked targets in NMEA 0183 (TTM), and the settings of its screen
 * (RSD), which show that it is working while it has no targets. Ignores targets being acquired;
 * drops lost ones, those silent for a minute, and later ones beyond a thousand.
 */
public final class NmeaRadar extends ParsedDevice<TrackingRadar.Tracks> implements TrackingRadar {
  private static final double MAX_RANGE_M = 500_000.0;
  private static final double MAX_MPS = 2_000.0;
  private static final int MAX_ID = 9_999;
  private static final Map<String, Double> METRES_PER_UNIT =
      Map.of("N", 1852.0, "K", 1000.0, "S", 1609.344);

  public NmeaRadar(ByteLink link) {
    super(link, new NmeaParser<>(new Targets()::read));
  }

  /** The targets of one radar. */
  private static final class Targets {
    private static final long FORGOTTEN_AFTER_MICROS = Clock.micros(60.0);
    private static final int MOST = 1_000; // each sentence costs time for all targets
    private static final double SECONDS_PER_HOUR = 3_600.0;

    private final Map<String, Track> byId = new TreeMap<>();

    // 1 number, 2 distance, 3 bearing, 4 T or R, 5 speed, 6 course, 7 T or R, 10 unit of distance
    // and of speed per hour, 12 status: T tracking, Q acquiring, L lost
    Optional<Tracks> read(NmeaSentence sentence, long nowMicros) {
      boolean isTarget = sentence.is("TTM");
      if (!isTarget && !sentence.is("RSD")) {
        return Optional.empty();
      }
      byId.values().removeIf(each -> nowMicros - each.measuredAtMicros() > FORGOTTEN_AFTER_MICROS);
      if (isTarget) {
        take(sentence, nowMicros);
      }
      return Optional.of(new Tracks(nowMicros, List.copyOf(byId.values())));
    }

    private void take(NmeaSentence sentence, long nowMicros) {
      String id = String.valueOf((int) number(sentence, 1, "target", 0.0, MAX_ID));
      if (!sentence.field(12).equals("T")) {
        byId.remove(id);
      } else if (byId.size() < MOST || byId.containsKey(id)) {
        byId.put(id, track(sentence, id, nowMicros));
      }
    }

    private static Track track(NmeaSentence sentence, String id, long nowMicros) {
      Double unitM = METRES_PER_UNIT.get(sentence.field(10));
      if (unitM == null) {
        throw new IllegalArgumentException(
            "unit \"" + sentence.field(10) + "\": expected N, K or S");
      }
      boolean isMoving = !sentence.field(5).isEmpty() && !sentence.field(6).isEmpty();
      double unitMps = unitM / SECONDS_PER_HOUR;
      return new Track(
          id,
          nowMicros,
          unitM * number(sentence, 2, "distance", 0.0, MAX_RANGE_M / unitM),
          direction(sentence, 3, "bearing"),
          OptionalDouble.empty(),
          isMoving
              ? OptionalDouble.of(unitMps * number(sentence, 5, "speed", 0.0, MAX_MPS / unitMps))
              : OptionalDouble.empty(),
          isMoving ? Optional.of(direction(sentence, 6, "course")) : Optional.empty());
    }

    private static Direction direction(NmeaSentence sentence, int field, String what) {
      double degrees = number(sentence, field, what, 0.0, 360.0);
      String from = sentence.field(field + 1);
      if (!from.equals("T") && !from.equals("R")) {
        throw new IllegalArgumentException(what + " relative to \"" + from + "\": expected T or R");
      }
      return new Direction(Math.toRadians(degrees), from.equals("T"));
    }

    private static double number(
        NmeaSentence sentence, int field, String what, double min, double max) {
      double value = Double.parseDouble(sentence.field(field));
      if (!(value >= min && value <= max)) {
        throw new IllegalArgumentException(
            what + " " + sentence.field(field) + " is outside " + min + "…" + max);
      }
      return value;
    }
  }

  /** Provider of RADAR = NMEA. */
  public static final class Provider extends LinkProvider<TrackingRadar> {
    public Provider() {
      super(TrackingRadar.class, NmeaRadar::new, "NMEA");
    }
  }
}
