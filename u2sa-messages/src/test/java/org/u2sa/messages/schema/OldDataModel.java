package org.u2sa.messages.schema;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * The data model of a released format: its own sources, kept by scripts/wire/freeze, compiled, in a
 * class loader that does not see the present ones. Reached by reflection only.
 */
final class OldDataModel implements AutoCloseable {
  private final URLClassLoader loader;
  private final Object codec;

  private OldDataModel(URLClassLoader loader, Object codec) {
    this.loader = loader;
    this.codec = codec;
  }

  /** The zip of a format's sources. */
  static Path sources(int format) {
    return Repository.file("u2sa-messages/src/test/formats/format-" + format + ".zip");
  }

  static OldDataModel of(int format, Path folder) throws IOException, ReflectiveOperationException {
    Path sources = Files.createDirectories(folder.resolve("src"));
    unpack(sources(format), sources);
    Path classes = Files.createDirectories(folder.resolve("classes"));
    compile(sources, classes);
    List<URL> urls = new ArrayList<>(List.of(classes.toUri().toURL()));
    urls.addAll(libraries());
    URLClassLoader loader =
        new URLClassLoader(
            urls.toArray(URL[]::new),
            ClassLoader.getPlatformClassLoader()); // not the present model
    Class<?> types = loader.loadClass("org.u2sa.messages.MessageTypes");
    Object codec =
        loader
            .loadClass("org.u2sa.messages.MessageCodec")
            .getConstructor(types)
            .newInstance(types.getMethod("standard").invoke(null));
    return new OldDataModel(loader, codec);
  }

  private static void unpack(Path archive, Path folder) throws IOException {
    try (ZipInputStream zip = new ZipInputStream(Files.newInputStream(archive))) {
      for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
        Path file = folder.resolve(entry.getName()).normalize();
        if (entry.getName().endsWith(".java") && file.startsWith(folder)) {
          Files.createDirectories(file.getParent());
          Files.write(file, zip.readAllBytes());
        }
      }
    }
  }

  private static void compile(Path sources, Path classes) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    try (Stream<Path> files = Files.walk(sources);
        StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, UTF_8)) {
      List<Path> java = files.filter(file -> file.toString().endsWith(".java")).toList();
      List<String> options =
          List.of(
              "-nowarn",
              "-proc:none",
              "-d",
              classes.toString(),
              "-cp",
              System.getProperty("java.class.path"));
      boolean compiled =
          compiler
              .getTask(
                  null, manager, null, options, null, manager.getJavaFileObjectsFromPaths(java))
              .call();
      if (!compiled) {
        throw new IllegalStateException("the old sources do not compile");
      }
    }
  }

  private static List<URL> libraries() throws MalformedURLException {
    List<URL> jars = new ArrayList<>();
    for (String part : System.getProperty("java.class.path").split(java.io.File.pathSeparator)) {
      if (part.endsWith(".jar")) {
        jars.add(Path.of(part).toUri().toURL());
      }
    }
    return jars;
  }

  /** A message as the old model reads it. */
  final class Read {
    private final Object message;

    private Read(Object message) {
      this.message = message;
    }

    String className() {
      return message.getClass().getSimpleName();
    }

    @Override
    public String toString() {
      return message.toString();
    }

    @SuppressWarnings("unchecked") // the old model says so too
    List<String> chain() throws ReflectiveOperationException {
      return (List<String>) message.getClass().getMethod("typeChain").invoke(message);
    }

    byte[] serialize() throws ReflectiveOperationException {
      return (byte[]) message.getClass().getMethod("serialize").invoke(message);
    }
  }

  /**
   * Reads bytes with the old model.
   *
   * @throws IllegalArgumentException with the old reader's words if it refuses them
   */
  Read decode(List<String> chain, byte[] bytes) throws ReflectiveOperationException {
    try {
      return new Read(
          codec
              .getClass()
              .getMethod("decode", List.class, byte[].class)
              .invoke(codec, chain, bytes));
    } catch (InvocationTargetException e) {
      throw new IllegalArgumentException(e.getCause().getMessage(), e.getCause());
    }
  }

  @Override
  public void close() throws IOException {
    loader.close();
  }
}
