package org.u2sa.service;

import java.util.Optional;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;

/**
 * Devices that the host of a run provides to its services instead of those their configurations
 * name, such as the sensors and actuators of a simulated vehicle.
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
   * The device of a service; called once per service, while it is constructed.
   *
   * @param port kind of device: an interface of {@code org.u2sa.device.port}
   * @param service name of the service
   * @param variables the service's variables; those that follow from the device may be overridden
   * @param clock the run's clock
   * @return empty: the service opens its configured device
   * @throws org.u2sa.interfaces.BadInputException if the service must not open its configured
   *     device, but there is no other for it
   */
  <D> Optional<D> device(Class<D> port, String service, XmlConfiguration variables, Clock clock);
}
