package org.u2sa.recorder.execution;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.InferredValue;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOverText;

/**
 * Everything a service was given on construction, including the files it then read: enough to
 * recreate it elsewhere.
 *
 * @param texts named values
 * @param files contents by name: {@link #CONFIGURATION}, {@code variables/NAME} for the file that a
 *     variable names, {@code state/NAME} for state left by an earlier instance, {@link
 *     #HANDED_OVER} for the state written by the service it replaced
 */
public record ExecutionStart(Map<String, String> texts, Map<String, byte[]> files) {
  /** Name prefix of metadata and attachments, followed by the execution's name. */
  public static final String PREFIX = "execution/";

  static final String CONFIGURATION = "configuration.xml";
  static final String OF_VARIABLE = "variables/";
  static final String OF_STATE = "state/";
  static final String HANDED_OVER = "handed-over";
  static final String FIRST_STEP = "first step";
  static final String TOLERATED = "tolerated";
  static final String OVERRIDE = "override ";
  static final String COPY = "changed copy";
  static final String CLASS = "class";
  static final String CONFIGURATION_NAME = "configuration";
  static final String SERVICE = "service";
  static final String INSTANCE = "instance";
  static final String THREAD = "thread";
  static final String RESTART = "restart";
  static final String SEED = "seed";
  static final String SYSTEM = "system";

  private static final long LARGEST_FILE = 16L << 20;
  private static final long LARGEST_STATE = 1L << 20;

  public ExecutionStart {
    texts = new LinkedHashMap<>(texts);
    files = new LinkedHashMap<>(files);
  }

  /**
   * Captures a service's initial inputs.
   *
   * @throws IOException if a file cannot be read
   */
  public static ExecutionStart before(String className, ServiceContext context) throws IOException {
    Map<String, String> texts = new LinkedHashMap<>();
    Map<String, byte[]> files = new LinkedHashMap<>();
    XmlConfiguration configuration = context.configuration();
    texts.put(CLASS, className);
    texts.put(SYSTEM, context.systemId());
    texts.put(SEED, Long.toString(context.seed()));
    texts.put(RESTART, Boolean.toString(context.isRestart()));
    texts.put(CONFIGURATION_NAME, configuration.origin());
    configuration.overrides().forEach((name, value) -> texts.put(OVERRIDE + name, typed(value)));
    if (!configuration.tolerated().isEmpty()) {
      texts.put(TOLERATED, String.join("\t", configuration.tolerated()));
    }
    configuration.copy().ifPresent(copy -> texts.put(COPY, copy.toString()));
    Optional<Path> read = configuration.copy().filter(Files::exists).or(configuration::file);
    if (read.isPresent()) {
      files.put(CONFIGURATION, Files.readAllBytes(read.get()));
    }
    files.putAll(state(context.logDirectory()));
    return new ExecutionStart(texts, files);
  }

  /** Value prefixed with its class letter, a small one if inferred, for {@link #value}. */
  static String typed(Object value) {
    if (value instanceof InferredValue inferred) {
      return typed(inferred.value()).substring(0, 1).toLowerCase(Locale.ROOT) + " " + inferred;
    }
    return value.getClass().getSimpleName().charAt(0) + " " + value;
  }

  /** Value of a {@link #typed} text. */
  static Object value(String typed) {
    String text = typed.substring(2);
    if (Character.isLowerCase(typed.charAt(0))) {
      return new InferredValue(text, value(typed.toUpperCase(Locale.ROOT)));
    }
    return switch (typed.charAt(0)) {
      case 'I' -> Integer.valueOf(text);
      case 'D' -> Double.valueOf(text);
      case 'B' -> Boolean.valueOf(text);
      default -> text;
    };
  }

  private static Map<String, byte[]> state(Path folder) throws IOException {
    Map<String, byte[]> found = new TreeMap<>();
    if (!Files.isDirectory(folder)) {
      return found;
    }
    try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
      for (Path file : all) {
        String name = file.getFileName().toString();
        boolean isState = name.endsWith(".progress") || name.endsWith(".mission");
        if (isState && Files.isRegularFile(file) && Files.size(file) <= LARGEST_STATE) {
          found.put(OF_STATE + name, Files.readAllBytes(file));
        }
      }
    }
    return found;
  }

  /**
   * Copy completed after construction of the service: its name and the XML files its variables
   * refer to. Other files are omitted, because they may contain passwords or keys.
   *
   * @throws IOException if a file cannot be read
   */
  public ExecutionStart after(KeptExecution execution, ServiceContext context) throws IOException {
    String service = execution.service().getServiceName();
    Map<String, String> moreTexts = new LinkedHashMap<>(texts);
    moreTexts.put(SERVICE, service);
    moreTexts.put(INSTANCE, execution.instance());
    moreTexts.put(THREAD, Integer.toString(execution.threadId()));
    Map<String, byte[]> moreFiles = new LinkedHashMap<>(files);
    moreFiles
        .keySet()
        .removeIf(name -> name.startsWith(OF_STATE) && !name.startsWith(OF_STATE + service + "."));
    for (Map.Entry<String, Object> variable : context.configuration().enumerateFields()) {
      if (variable.getValue() instanceof String value && isFile(context, value)) {
        Path file = context.configuration().resolve(value);
        moreFiles.put(OF_VARIABLE + variable.getKey(), Files.readAllBytes(file));
        moreTexts.put(OF_VARIABLE + variable.getKey(), value);
      }
    }
    execution
        .inherited()
        .ifPresent(
            before -> {
              before
                  .firstStepMicros()
                  .ifPresent(micros -> moreTexts.put(FIRST_STEP, Long.toString(micros)));
              moreFiles.put(HANDED_OVER, HandOverText.bytes(before.state(), context.systemId()));
            });
    return new ExecutionStart(moreTexts, moreFiles);
  }

  /** Whether a variable may name a file to record: XML or a height map, not passwords or keys. */
  public static boolean isRecorded(String value) {
    return value.endsWith(".xml") || value.endsWith(".asc");
  }

  private static boolean isFile(ServiceContext context, String value) throws IOException {
    if (!isRecorded(value)) {
      return false;
    }
    try {
      Path file = context.configuration().resolve(value);
      return Files.isRegularFile(file) && Files.size(file) <= LARGEST_FILE;
    } catch (InvalidPathException e) {
      return false; // a value that only resembles a file name
    }
  }

  /**
   * Writes the texts as metadata and the files as attachments.
   *
   * @throws IOException if it cannot be written
   */
  public void write(McapWriter writer, String execution, long nanos) throws IOException {
    writer.add(new McapMetadata(PREFIX + execution, texts));
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      String name = PREFIX + execution + "/" + file.getKey();
      writer.add(new McapAttachment(nanos, 0, name, "text/xml", file.getValue()));
    }
  }

  /**
   * Reads all execution starts of a recording, by execution name.
   *
   * @param files files of the recording, oldest first
   * @throws IOException if one cannot be read
   */
  public static Map<String, ExecutionStart> all(List<Path> files) throws IOException {
    Map<String, ExecutionStart> all = new LinkedHashMap<>();
    for (Path file : files) {
      try (McapReader reader = McapReader.open(file)) {
        all.putAll(of(reader));
      }
    }
    return all;
  }

  private static Map<String, ExecutionStart> of(McapReader reader) throws IOException {
    Map<String, ExecutionStart> all = new LinkedHashMap<>();
    for (McapMetadata metadata : reader.metadata()) {
      if (metadata.name().startsWith(PREFIX)) {
        Map<String, byte[]> files = new LinkedHashMap<>();
        String prefix = metadata.name() + "/";
        for (String name : reader.attachmentNames()) {
          if (name.startsWith(prefix)) {
            files.put(
                name.substring(prefix.length()), reader.attachment(name).orElseThrow().data());
          }
        }
        all.put(
            metadata.name().substring(PREFIX.length()),
            new ExecutionStart(metadata.entries(), files));
      }
    }
    return all;
  }

  long number(String name) throws McapException {
    try {
      return Long.parseLong(text(name));
    } catch (NumberFormatException e) {
      throw new McapException(
          name + " of " + service() + ": \"" + text(name) + "\" is not a whole number", e);
    }
  }

  /** Thread ID of the service; 0 if not recorded. */
  int threadId() throws McapException {
    return texts.containsKey(THREAD) ? (int) number(THREAD) : 0;
  }

  String text(String name) {
    return texts.getOrDefault(name, "");
  }

  /** Service name. */
  public String service() {
    return text(SERVICE);
  }

  /** Configuration file name without folder; the configuration's own name if not from a file. */
  public String configurationName() {
    String origin = text(CONFIGURATION_NAME).replace('\\', '/');
    return origin.substring(origin.lastIndexOf('/') + 1);
  }

  /**
   * Copy with another configuration file and the files it names. Overrides set by the run are kept.
   *
   * @throws org.u2sa.interfaces.BadInputException if the file is not a configuration
   */
  public ExecutionStart withConfiguration(Path file) {
    Map<String, String> otherTexts = new LinkedHashMap<>(texts);
    Map<String, byte[]> otherFiles = new LinkedHashMap<>(files);
    try {
      otherFiles.put(CONFIGURATION, Files.readAllBytes(file));
      for (XmlElement variable : XmlReader.read(file, "configuration").children("variable")) {
        String name = variable.attribute("name");
        String value = variable.optionalAttribute("value").orElse("");
        Path named = file.toAbsolutePath().resolveSibling(value);
        boolean isNew = !texts.containsKey(OVERRIDE + name) && isRecorded(value);
        if (isNew && Files.isRegularFile(named)) {
          otherTexts.put(OF_VARIABLE + name, value);
          otherFiles.put(OF_VARIABLE + name, Files.readAllBytes(named));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read " + file + " and the files that it names", e);
    }
    return new ExecutionStart(otherTexts, otherFiles);
  }

  /** Full name of the service's class. */
  public String className() {
    return text(CLASS);
  }

  /** Simple name of the service's class. */
  public String simpleClassName() {
    String name = className();
    return name.substring(Math.max(name.lastIndexOf('.'), name.lastIndexOf('$')) + 1);
  }
}
