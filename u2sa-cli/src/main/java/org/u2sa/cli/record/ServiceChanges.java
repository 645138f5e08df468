package org.u2sa.cli.record;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.cli.command.Setting;
import org.u2sa.core.launch.ServiceFactory;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.recorder.execution.ExecutionStart;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** Changes to apply when re-executing services. */
final class ServiceChanges {
  private static final Pattern CLASS = Pattern.compile("([^:=]+)=([\\w.$]+)");

  private final List<Setting> settings = new ArrayList<>();
  private final Map<String, String> classes = new LinkedHashMap<>(); // by service
  private final Map<String, Path> configurations = new LinkedHashMap<>(); // by service

  private ServiceChanges() {}

  /**
   * Reads changes.
   *
   * @param starts the services to re-execute
   * @throws BadInputException if one cannot be read or applies to none of these services
   */
  static ServiceChanges parse(List<String> texts, Collection<ExecutionStart> starts) {
    ServiceChanges changes = new ServiceChanges();
    for (String text : texts) {
      changes.add(text, starts);
    }
    return changes;
  }

  private void add(String text, Collection<ExecutionStart> starts) {
    Matcher ofClass = CLASS.matcher(text);
    if (text.endsWith(".xml") && Files.isRegularFile(Path.of(text))) {
      addFile(Path.of(text), starts);
    } else if (ofClass.matches()) {
      classes.put(service(ofClass.group(1), text, starts), ofClass.group(2));
    } else {
      try {
        Setting setting = Setting.parse(text);
        String service = service(setting.service(), text, starts);
        settings.add(new Setting(service, setting.variable(), setting.value()));
      } catch (IllegalArgumentException e) {
        throw new BadInputException(
            "--against "
                + text
                + ": expected SERVICE:VARIABLE=VALUE, SERVICE=CLASS, or a system or configuration file (*.xml) that exists",
            e);
      }
    }
  }

  private static String service(String name, String text, Collection<ExecutionStart> starts) {
    return starts.stream()
        .filter(start -> name.equals(start.service()) || name.equals(start.simpleClassName()))
        .findFirst()
        .map(ExecutionStart::service)
        .orElseThrow(
            () ->
                new BadInputException(
                    "--against "
                        + text
                        + ": \""
                        + name
                        + "\" is not re-executed; expected one of "
                        + starts.stream().map(ExecutionStart::service).toList()));
  }

  /**
   * Applies a configuration or system file; a system file changes the services with the same
   * configuration names.
   */
  private void addFile(Path file, Collection<ExecutionStart> starts) {
    String fileName = file.getFileName().toString();
    boolean isSystem =
        starts.stream().noneMatch(start -> fileName.equals(start.configurationName()));
    int changed = 0;
    for (ExecutionStart start : starts) {
      if (!isSystem) {
        if (fileName.equals(start.configurationName())) {
          configurations.put(start.service(), file);
          changed++;
        }
        continue;
      }
      for (SystemFile.Entry entry : SystemFile.read(file).services()) {
        Optional<Path> own = entry.configuration();
        boolean is =
            own.isPresent()
                ? own.get().getFileName().toString().equals(start.configurationName())
                : entry.className().equals(start.className());
        if (is) {
          own.ifPresent(configuration -> configurations.put(start.service(), configuration));
          classes.put(start.service(), entry.className());
          changed++;
        }
      }
    }
    if (changed == 0) {
      throw new BadInputException(
          "--against "
              + file
              + ": applies to none of the services "
              + starts.stream().map(ExecutionStart::service).toList()
              + "; configurations are identified by their file names, expected one of "
              + starts.stream().map(ExecutionStart::configurationName).toList());
    }
  }

  /** A service's start with its changed configuration file, if any. */
  ExecutionStart configurationOf(ExecutionStart start) {
    Path file = configurations.get(start.service());
    return file == null ? start : start.withConfiguration(file);
  }

  U2SAService make(ExecutionStart start, ServiceContext context) {
    for (Setting setting : settings) {
      if (setting.service().equals(start.service())) {
        context.configuration().override(setting.variable(), setting.value());
      }
    }
    String className = classes.getOrDefault(start.service(), start.className());
    if (!className.equals(start.className())) {
      context.configuration().override("SERVICE NAME", start.service());
    }
    return ServiceFactory.create(className, context);
  }
}
