package org.u2sa.drivers.range;

import org.u2sa.device.DeviceProvider;
import org.u2sa.device.RangeFinder;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.service.ServiceContext;

/** A MaxBotix sonar on a link; it measures by itself, again and again. */
public final class SerialSonar extends ParsedDevice<RangeFinder.Distance> implements RangeFinder {
  /** Over that link, which is closed with this. */
  public SerialSonar(ByteLink link, SonarModel model) {
    super(link, new SonarParser(model));
  }

  /** MODEL LV, XL and HR in a configuration. */
  public static final class Provider extends DeviceProvider<RangeFinder> {
    /** For {@link java.util.ServiceLoader}. */
    public Provider() {
      super(RangeFinder.class, "LV", "XL", "HR");
    }

    @Override
    protected RangeFinder open(String name, ServiceContext context) {
      return new SerialSonar(ByteLinks.of(context), SonarModel.valueOf(name));
    }
  }
}
