package org.u2sa.device;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.service.ServiceContext;

/** Finds the device that a service's configuration names among all {@link DeviceProvider}s. */
public final class Devices {
  private Devices() {}

  /**
   * The device of a service. Declares the variables of all the port's devices.
   *
   * @param choice which device; its default is the usual one, its choices are those that exist
   * @param made by the host, such as a phone or a simulation: used whatever the configuration says
   * @throws BadInputException if nobody offers the named device, or two offer the same name
   */
  public static <D extends Device<?>> D open(
      Class<D> port, VariableDeclaration<String> choice, ServiceContext context, Optional<D> made) {
    Map<String, DeviceProvider<?>> providers = new LinkedHashMap<>();
    for (DeviceProvider<?> provider : ServiceLoader.load(DeviceProvider.class)) {
      if (provider.port() == port) {
        provider.names().forEach(name -> offer(providers, name, provider));
        provider.variables().forEach(context.configuration()::getVariable);
      }
    }
    List<String> names = new ArrayList<>(providers.keySet());
    choice.ifAbsent().filter(usual -> !names.contains(usual)).ifPresent(names::add);
    String name = context.configuration().getVariable(choice.oneOf(names.toArray(new String[0])));
    return made.orElseGet(
        () -> port.cast(named(name, providers, port, choice).open(name, context)));
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
      String name,
      Map<String, DeviceProvider<?>> providers,
      Class<?> port,
      VariableDeclaration<?> choice) {
    DeviceProvider<?> provider = providers.get(name);
    if (provider == null) {
      throw new BadInputException(
          ("variable \"" + choice.name() + "\": no driver on the class path offers ")
              + (port.getSimpleName() + " \"" + name + "\"; there are " + providers.keySet()));
    }
    return provider;
  }
}
