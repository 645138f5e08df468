package org.u2sa.drivers.traffic;

import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;

/**
 * A GDL 90 ADS-B receiver such as Stratux, Sentry or SkyEcho, usually on UDP port 4000. Ownship
 * reports are ignored.
 */
public final class Gdl90Receiver extends ParsedDevice<TrafficReceiver.Traffic>
    implements TrafficReceiver {
  public Gdl90Receiver(ByteLink link) {
    super(link, new Gdl90Parser());
  }

  /** Provider of RECEIVER = GDL90. */
  public static final class Provider extends LinkProvider<TrafficReceiver> {
    public Provider() {
      super(TrafficReceiver.class, Gdl90Receiver::new, "GDL90");
    }
  }
}
