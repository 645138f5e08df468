package org.u2sa.drivers.traffic;

import java.util.Optional;
import org.u2sa.device.port.TrafficPicture;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.drivers.nmea.NmeaParser;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * An AIS receiver that sends AIVDM sentences, at a serial port or on the network. Ignores messages
 * of several sentences, which are not position reports, and the own ship (AIVDO).
 */
public final class AisReceiver extends ParsedDevice<TrafficReceiver.Traffic>
    implements TrafficReceiver {
  public AisReceiver(ByteLink link) {
    super(link, new NmeaParser<>(new Vessels()::read));
  }

  /** The vessels received by one receiver. */
  private static final class Vessels {
    private final TrafficPicture picture = new TrafficPicture();

    // field 1: number of sentences, 2: number of this one, 5: message
    Optional<Traffic> read(NmeaSentence sentence, long nowMicros) {
      if (!sentence.is("VDM")) {
        return Optional.empty();
      }
      if (sentence.field(1).equals("1")) {
        AisReport.target(sentence.field(5), nowMicros)
            .ifPresent(target -> picture.heard(target, nowMicros));
      }
      picture.alive(nowMicros);
      return picture.latest();
    }
  }

  /** Provider of RECEIVER = AIS. */
  public static final class Provider extends LinkProvider<TrafficReceiver> {
    public Provider() {
      super(TrafficReceiver.class, AisReceiver::new, "AIS");
    }
  }
}
