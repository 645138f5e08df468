package org.u2sa.device;

import java.util.List;
import org.u2sa.device.port.Device;
import org.u2sa.service.ServiceContext;

/**
 * Offers devices of one kind by name. A public class with a public no-argument constructor, listed
 * in {@code META-INF/services/org.u2sa.device.DeviceProvider}; every service of that port then
 * accepts the names.
 */
public abstract class DeviceProvider<D extends Device<?>> {
  private final Class<D> port;
  private final List<String> names;

  /**
   * @param port such as {@code Imu.class}
   * @param names such as {@code VECTORNAV}; unique among the port's providers
   */
  protected DeviceProvider(Class<D> port, String... names) {
    this.port = port;
    this.names = List.of(names);
  }

  final Class<D> port() {
    return port;
  }

  final List<String> names() {
    return names;
  }

  /**
   * Records of the {@link org.u2sa.interfaces.configuration.Variable}s of these devices.
   * Configurations of the port's services may set them regardless of the selected device.
   */
  protected List<Class<?>> variables() {
    return List.of();
  }

  /**
   * Creates the device immediately; it need not be connected yet.
   *
   * @throws org.u2sa.interfaces.BadInputException if a variable does not fit the device
   */
  protected abstract D open(String name, ServiceContext context);
}
