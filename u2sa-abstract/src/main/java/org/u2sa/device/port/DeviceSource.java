package org.u2sa.device.port;

import java.util.Optional;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;

/**
 * Devices that the host of a run provides in place of the configured ones, such as a simulated
 * vehicle's sensors.
 */
public interface DeviceSource {
  /** Provides none: every service opens its configured device. */
  DeviceSource NONE =
      new DeviceSource() {
        @Override
        public <D> Optional<D> device(
            Class<D> port, String service, XmlConfiguration variables, Clock clock) {
          return Optional.empty();
        }
      };

  /**
   * Device of a service; called once, while the service is constructed.
   *
   * @param port kind of device: an interface of {@code org.u2sa.device.port}
   * @param variables those that follow from the device may be overridden
   * @return empty: the service opens its configured device
   * @throws org.u2sa.interfaces.BadInputException if it must not, but there is no other device for
   *     it
   */
  <D> Optional<D> device(Class<D> port, String service, XmlConfiguration variables, Clock clock);
}
