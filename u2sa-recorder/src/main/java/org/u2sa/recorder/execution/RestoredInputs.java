package org.u2sa.recorder.execution;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOverText;

/**
 * Restores a service's inputs in a folder, so that it can be recreated. Nothing outside the folder
 * is written, whatever the recording contains.
 */
final class RestoredInputs {
  /** Nested folders, so that a configuration may use paths that go up this many levels. */
  private static final String DEPTH = "1/2/3/4/5/6";

  private static final Set<String> NO_NAMES = Set.of("", ".", "..");

  private final ExecutionStart start;
  private final Path folder;
  private final Map<String, String> recordedPaths = new LinkedHashMap<>(); // by path in the folder

  RestoredInputs(ExecutionStart start, Path folder) {
    this.start = start;
    this.folder = folder.toAbsolutePath().normalize();
  }

  /** Service context, without the execution. */
  ServiceContext context(MessageTypes types) throws IOException {
    XmlConfiguration configuration = configuration();
    Path logs = Files.createDirectories(folder.resolve("logs"));
    for (Map.Entry<String, byte[]> file : start.files().entrySet()) {
      if (file.getKey().startsWith(ExecutionStart.OF_STATE)) {
        String name = lastName(file.getKey());
        Files.write(logs.resolve(name), file.getValue());
      }
    }
    return ServiceContext.of(start.text(ExecutionStart.SYSTEM), configuration)
        .transport(new Silent(start.text(ExecutionStart.SYSTEM), instance()))
        .logDirectory(logs)
        .messageTypes(types)
        .seed(start.number(ExecutionStart.SEED))
        .restart(Boolean.parseBoolean(start.text(ExecutionStart.RESTART)))
        .build();
  }

  /**
   * State inherited from the replaced service; empty if it replaced none.
   *
   * @throws IOException if it cannot be read
   */
  Optional<Execution.Inheritance> inheritance(MessageTypes types) throws IOException {
    byte[] handedOver = start.files().get(ExecutionStart.HANDED_OVER);
    if (handedOver == null) {
      return Optional.empty();
    }
    Path file = Files.write(folder.resolve(ExecutionStart.HANDED_OVER), handedOver);
    String firstStep = start.text(ExecutionStart.FIRST_STEP);
    return Optional.of(
        new Execution.Inheritance(
            start.service(),
            HandOverText.read(file, start.text(ExecutionStart.SYSTEM), new MessageCodec(types)),
            firstStep.isEmpty()
                ? OptionalLong.empty()
                : OptionalLong.of(start.number(ExecutionStart.FIRST_STEP))));
  }

  /** Text with the paths of the recorded run in place of those of its files in the folder. */
  String asRecorded(String text) {
    String result = text;
    for (Map.Entry<String, String> path : recordedPaths.entrySet()) {
      result = result.replace(path.getKey(), path.getValue());
    }
    return result;
  }

  private String instance() {
    return start.text(ExecutionStart.INSTANCE);
  }

  private static String lastName(String path) throws McapException {
    try {
      Path name = Paths.get(path.replace('\\', '/')).getFileName();
      if (name != null && !NO_NAMES.contains(name.toString())) {
        return name.toString();
      }
    } catch (InvalidPathException e) {
      throw new McapException("a file cannot have the name \"" + path + "\"", e);
    }
    throw new McapException("a file cannot have the name \"" + path + "\"");
  }

  private XmlConfiguration configuration() throws IOException {
    byte[] content = start.files().get(ExecutionStart.CONFIGURATION);
    String origin = start.text(ExecutionStart.CONFIGURATION_NAME);
    XmlConfiguration configuration;
    if (content == null) {
      configuration = XmlConfiguration.inMemory(origin, Map.of());
    } else {
      Path file = Files.createDirectories(folder.resolve(DEPTH)).resolve(lastName(origin));
      Files.write(file, content);
      recordedPaths.put(file.toString(), origin);
      String changed = start.text(ExecutionStart.COPY);
      if (changed.isEmpty()) {
        configuration = XmlConfiguration.load(file);
      } else {
        Path copy = Files.createDirectories(folder.resolve("changed")).resolve(lastName(origin));
        recordedPaths.put(copy.toString(), changed);
        configuration = XmlConfiguration.load(file, copy);
      }
    }
    for (Map.Entry<String, String> text : start.texts().entrySet()) {
      if (text.getKey().startsWith(ExecutionStart.OVERRIDE)) {
        configuration.override(
            text.getKey().substring(ExecutionStart.OVERRIDE.length()),
            ExecutionStart.value(text.getValue()));
      }
    }
    String tolerated = start.text(ExecutionStart.TOLERATED);
    configuration.tolerate(tolerated.isEmpty() ? List.of() : List.of(tolerated.split("\t")));
    for (Map.Entry<String, byte[]> file : start.files().entrySet()) {
      if (file.getKey().startsWith(ExecutionStart.OF_VARIABLE)) {
        layOut(configuration, file.getKey(), file.getValue());
      }
    }
    return configuration;
  }

  /**
   * Writes a file to the path its variable gives if inside the folder; otherwise elsewhere in the
   * folder. The variable keeps its value, because the service may publish it.
   */
  private void layOut(XmlConfiguration configuration, String key, byte[] content)
      throws IOException {
    String value = start.text(key);
    Path meant = configuration.resolve(value).toAbsolutePath().normalize();
    if (configuration.file().isEmpty() || !meant.startsWith(folder)) {
      String name = key.substring(ExecutionStart.OF_VARIABLE.length());
      meant = folder.resolve("files").resolve(lastName(name)).resolve(lastName(value));
      configuration.relocate(value, meant);
    }
    Files.createDirectories(meant.getParent());
    Files.write(meant, content);
    Path origin = Paths.get(start.text(ExecutionStart.CONFIGURATION_NAME));
    Path recorded =
        configuration.file().isPresent()
            ? origin.resolveSibling(value).normalize()
            : Paths.get(value);
    recordedPaths.put(meant.toString(), recorded.toString());
  }

  /** A transport without peers; the execution handles all messages. */
  private record Silent(String systemId, String instance) implements Transport {
    @Override
    public Connection connect(String serviceName, Receiver receiver) {
      return new SilentConnection(instance);
    }
  }

  private record SilentConnection(String instance) implements Connection {
    @Override
    public boolean publish(Channel<?> channel, U2SAData message) {
      return true;
    }

    @Override
    public boolean subscribe(Channel<?> channel) {
      return true;
    }

    @Override
    public boolean unsubscribe(Channel<?> channel) {
      return true;
    }

    @Override
    public long refused() {
      return 0;
    }

    @Override
    public long missed() {
      return 0;
    }

    @Override
    public void close() {
      // nothing to close
    }
  }
}
