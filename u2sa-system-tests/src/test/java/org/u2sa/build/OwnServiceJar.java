package org.u2sa.build;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import javax.tools.ToolProvider;
import org.u2sa.service.U2SAService;

/** A user's jar for the application: a service, and a provider in a list that U2SA has, too. */
final class OwnServiceJar {
  /** Its service, as dex files name it. */
  static final String DESCRIPTOR = "Lorg/example/blinker/Blinker;";

  /** The list. */
  static final String PROVIDED = "org.u2sa.messages.schema.MessageTypeProvider";

  /** Its entry. */
  static final String PROVIDER = "org.example.blinker.NoTypes";

  private static final String SERVICE =
      """
      package org.example.blinker;

      public final class Blinker extends org.u2sa.service.U2SAService {
        public Blinker(org.u2sa.service.ServiceContext context) {
          super(context, org.u2sa.service.ServiceRole.OBSERVER, "Blinker");
        }

        @Override
        public void callback(org.u2sa.messages.schema.U2SAData data) {}

        @Override
        public void run() {
          record Blink(int number) {}
          log(switch (new Blink(1).number()) {
            case 1 -> "on";
            default -> "off";
          });
        }

        @Override
        public void kill() {}
      }
      """;
  private static final String TYPES =
      """
      package org.example.blinker;

      public final class NoTypes implements org.u2sa.messages.schema.MessageTypeProvider {
        @Override
        public java.util.Collection<org.u2sa.messages.schema.MessageType<?>> messageTypes() {
          return java.util.List.of();
        }
      }
      """;

  private OwnServiceJar() {}

  /** Compiles the jar. */
  static Path in(Path folder) throws IOException {
    Path sources = Files.createDirectories(folder.resolve("blinker"));
    Path service = Files.writeString(sources.resolve("Blinker.java"), SERVICE);
    Path types = Files.writeString(sources.resolve("NoTypes.java"), TYPES);
    Path classes = Files.createDirectories(folder.resolve("classes"));
    int result =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "--release",
                "17",
                "-cp",
                System.getProperty("java.class.path"),
                "-d",
                classes.toString(),
                service.toString(),
                types.toString());
    assertThat(result).as("javac").isZero();
    Map<String, byte[]> entries = new LinkedHashMap<>();
    Path compiled = classes.resolve("org/example/blinker");
    try (var files = Files.list(compiled)) {
      for (Path each : files.sorted().toList()) {
        entries.put("org/example/blinker/" + each.getFileName(), Files.readAllBytes(each));
      }
    }
    entries.put("META-INF/services/" + PROVIDED, PROVIDER.getBytes(UTF_8));
    return write(folder.resolve("blinker.jar"), entries);
  }

  /** A jar with a class that the application has. */
  static String fat(Path folder) throws IOException {
    String name = U2SAService.class.getName().replace('.', '/') + ".class";
    try (InputStream in = U2SAService.class.getClassLoader().getResourceAsStream(name)) {
      return write(folder.resolve("fat.jar"), Map.of(name, in.readAllBytes())).toString();
    }
  }

  private static Path write(Path jar, Map<String, byte[]> entries) throws IOException {
    try (OutputStream out = Files.newOutputStream(jar);
        ZipOutputStream archive = new ZipOutputStream(out)) {
      for (Map.Entry<String, byte[]> each : entries.entrySet()) {
        archive.putNextEntry(new ZipEntry(each.getKey()));
        archive.write(each.getValue());
      }
    }
    return jar;
  }
}
