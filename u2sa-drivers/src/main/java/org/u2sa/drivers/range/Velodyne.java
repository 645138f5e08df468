package org.u2sa.drivers.range;

import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.PointScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.service.ServiceContext;

/** A Velodyne VLP-16 (Puck), which sends its data packets to UDP port 2368. */
public final class Velodyne extends ParsedDevice<PointScanner.Cloud> implements PointScanner {
  /** Uses the link; closing the device closes it. */
  public Velodyne(ByteLink link) {
    super(link, new VelodyneParser());
  }

  /** Provider of SCANNER = VLP-16. */
  public static final class Provider extends DeviceProvider<PointScanner> {
    /** Constructor for {@link java.util.ServiceLoader}. */
    public Provider() {
      super(PointScanner.class, "VLP-16");
    }

    @Override
    protected PointScanner open(String name, ServiceContext context) {
      return new Velodyne(ByteLinks.of(context));
    }
  }
}
