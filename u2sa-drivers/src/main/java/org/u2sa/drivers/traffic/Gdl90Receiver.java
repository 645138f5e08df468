package org.u2sa.drivers.traffic;

import org.u2sa.device.DeviceProvider;
import org.u2sa.device.TrafficReceiver;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.service.ServiceContext;

/**
 * An ADS-B receiver that speaks GDL 90, as Stratux, Sentry, SkyEcho and most others do, usually by
 * UDP to port 4000. Its own ship's reports are passed over.
 */
public final class Gdl90Receiver extends ParsedDevice<TrafficReceiver.Traffic>
    implements TrafficReceiver {
  /** Over that link, which is closed with this. */
  public Gdl90Receiver(ByteLink link) {
    super(link, new Gdl90Parser());
  }

  /** RECEIVER GDL90 in a configuration. */
  public static final class Provider extends DeviceProvider<TrafficReceiver> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(TrafficReceiver.class, "GDL90");
    }

    @Override
    protected TrafficReceiver open(String name, ServiceContext context) {
      return new Gdl90Receiver(ByteLinks.of(context));
    }
  }
}
