package org.u2sa.drivers.link;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.Device;
import org.u2sa.service.ServiceContext;

/** Base of providers whose devices use the link of the variable CONNECTION. */
public abstract class LinkProvider<D extends Device<?>> extends DeviceProvider<D> {
  /** Creates a device with additional variables. */
  @FunctionalInterface
  protected interface Opener<D, V> {
    /** Creates the device that the configuration names. */
    D open(String name, ByteLink link, V variables);
  }

  private final List<Class<?>> variables;
  private final BiFunction<String, ServiceContext, D> opener;

  /** See {@link DeviceProvider#DeviceProvider}. */
  protected LinkProvider(Class<D> port, Function<ByteLink, D> opener, String... names) {
    this(port, (name, link) -> opener.apply(link), names);
  }

  /**
   * @param opener creates the device that the configuration names
   */
  protected LinkProvider(Class<D> port, BiFunction<String, ByteLink, D> opener, String... names) {
    super(port, names);
    variables = List.of();
    this.opener = (name, context) -> opener.apply(name, ByteLinks.of(context));
  }

  /**
   * @param variables record of the devices' additional variables
   */
  protected <V> LinkProvider(
      Class<D> port, Class<V> variables, Opener<D, V> opener, String... names) {
    super(port, names);
    this.variables = List.of(variables);
    this.opener =
        (name, context) ->
            opener.open(
                name, ByteLinks.of(context), context.configuration().settings(variables).get());
  }

  @Override
  protected final List<Class<?>> variables() {
    return variables;
  }

  @Override
  protected final D open(String name, ServiceContext context) {
    return opener.apply(name, context);
  }
}
