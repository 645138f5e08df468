package org.u2sa.drivers.range;

import org.u2sa.device.port.PointScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;

/** A Velodyne VLP-16 (Puck), which sends its data packets to UDP port 2368. */
public final class Velodyne extends ParsedDevice<PointScanner.Cloud> implements PointScanner {
  public Velodyne(ByteLink link) {
    super(link, new VelodyneParser());
  }

  /** Provider of SCANNER = VLP-16. */
  public static final class Provider extends LinkProvider<PointScanner> {
    public Provider() {
      super(PointScanner.class, Velodyne::new, "VLP-16");
    }
  }
}
