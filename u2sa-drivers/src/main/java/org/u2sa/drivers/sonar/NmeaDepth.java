package org.u2sa.drivers.sonar;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * An NMEA 0183 echo sounder: depth below the transducer from DPT, or from DBT in metres. Devices
 * that send both report each depth twice.
 */
public final class NmeaDepth extends ParsedDevice<RangeFinder.Distance> implements RangeFinder {
  private static final double DEEPEST_M = 12_000.0;

  public NmeaDepth(ByteLink link) {
    super(link, new NmeaParser<>(NmeaDepth::distance));
  }

  private static Optional<Distance> distance(NmeaSentence sentence, long nowMicros) {
    int field = sentence.is("DPT") ? 1 : sentence.is("DBT") ? 3 : 0;
    if (field == 0) {
      return Optional.empty();
    }
    String text = sentence.field(field);
    if (text.isEmpty()) {
      return Optional.of(new Distance(nowMicros, OptionalDouble.empty())); // bottom out of range
    }
    double metres = Double.parseDouble(text);
    if (!(metres >= 0.0 && metres <= DEEPEST_M)) {
      throw new IllegalArgumentException("depth " + text + " is outside 0…" + DEEPEST_M + " m");
    }
    return Optional.of(new Distance(nowMicros, OptionalDouble.of(metres)));
  }

  /** Provider of MODEL = NMEA DEPTH. */
  public static final class Provider extends LinkProvider<RangeFinder> {
    public Provider() {
      super(RangeFinder.class, NmeaDepth::new, "NMEA DEPTH");
    }
  }
}
