package org.u2sa.device;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * Providers that {@link Devices} finds, on the thread that opens this, until it is closed. They are
 * registered here and not in the tests' resources because Maven, before it packages, gives other
 * modules the whole folder of this module's test classes instead of the fixtures' jar.
 */
final class RegisteredProviders implements AutoCloseable {
  private final ClassLoader before = Thread.currentThread().getContextClassLoader();
  private final URLClassLoader loader;

  /**
   * @param folder an empty one for the list of the providers
   */
  RegisteredProviders(Path folder, Class<?>... providers) throws IOException {
    Path list = folder.resolve("META-INF/services").resolve(DeviceProvider.class.getName());
    Files.createDirectories(list.getParent());
    Files.writeString(list, Stream.of(providers).map(Class::getName).collect(joining("\n")));
    loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before);
    Thread.currentThread().setContextClassLoader(loader);
  }

  @Override
  public void close() throws IOException {
    Thread.currentThread().setContextClassLoader(before);
    loader.close();
  }
}
