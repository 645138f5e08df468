package org.u2sa.device;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import org.u2sa.device.port.Device;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.service.ServiceContext;

/** Finds the device that a service's configuration names among all {@link DeviceProvider}s. */
public final class Devices {
  /** Name in a configuration for a device that the host provides. */
  public static final String SIMULATED = "SIMULATED";

  private Devices() {}

  /**
   * Defaults of a service's device configuration.
   *
   * @param noun name of the device in descriptions: {@code compass}
   * @param variable that names the driver: {@code COMPASS}
   * @param driver its default
   * @param connection default of the variable CONNECTION
   */
  public record Usual(String noun, String variable, String driver, String connection) {}

  /**
   * The device of a service. Declares CONNECTION, the variable that names the driver, and the
   * variables of all the port's drivers.
   *
   * @param made device provided by the host, such as a phone; overrides the configuration, as do
   *     devices from {@link ServiceContext#devices()}
   * @throws BadInputException if there is no such driver, or more than one
   */
  public static <D extends Device<?>> D open(
      Class<D> port, Usual usual, ServiceContext context, String service, Optional<D> made) {
    XmlConfiguration configuration = context.configuration();
    if (context.devices() != ServiceContext.DeviceSource.NONE) {
      context.beforeDevice(); // a simulated one is also a device
    }
    Optional<D> provided =
        made.isPresent()
            ? made
            : context.devices().device(port, service, configuration, context.clock());
    configuration.getVariable(
        VariableDeclaration.text("CONNECTION")
            .ifAbsent(usual.connection)
            .describedAs(
                ("Address of the " + usual.noun)
                    + ", in the driver's format (docs/drivers/links.md)."));
    Map<String, DeviceProvider<?>> providers = new LinkedHashMap<>();
    for (DeviceProvider<?> provider : ServiceLoader.load(DeviceProvider.class)) {
      if (provider.port() == port) {
        provider.names().forEach(name -> offer(providers, name, provider));
        provider.variables().forEach(configuration::settings);
      }
    }
    Set<String> names = new LinkedHashSet<>(providers.keySet());
    names.add(usual.driver);
    if (provided.isPresent()) {
      names.add(SIMULATED);
    }
    String name =
        configuration.getVariable(
            VariableDeclaration.text(usual.variable)
                .oneOf(names.toArray(new String[0]))
                .ifAbsent(usual.driver)
                .describedAs("Kind of " + usual.noun + ": the name of a driver."));
    if (provided.isPresent()) {
      return provided.get();
    }
    DeviceProvider<?> provider = named(name, providers, port, usual.variable);
    context.beforeDevice();
    D opened = port.cast(provider.open(name, context));
    context.onAbandon(opened::close);
    return opened;
  }

  private static void offer(
      Map<String, DeviceProvider<?>> providers, String name, DeviceProvider<?> provider) {
    DeviceProvider<?> other = providers.putIfAbsent(name, provider);
    if (other != null) {
      throw new BadInputException(
          provider.port().getSimpleName()
              + (" \"" + name + "\" is offered by both ")
              + (other.getClass().getName() + " and " + provider.getClass().getName()));
    }
  }

  private static DeviceProvider<?> named(
      String name, Map<String, DeviceProvider<?>> providers, Class<?> port, String variable) {
    DeviceProvider<?> provider = providers.get(name);
    if (provider == null) {
      throw new BadInputException(
          ("variable \"" + variable + "\": no driver on the class path offers ")
              + (port.getSimpleName() + " \"" + name + "\"; there are " + providers.keySet()));
    }
    return provider;
  }
}
