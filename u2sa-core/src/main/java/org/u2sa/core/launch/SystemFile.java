package org.u2sa.core.launch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/**
 * The list of a vehicle's services (thesis 3.2): what runs, with which configuration.
 *
 * <pre>{@code
 * <system id="cessna">
 *   <communication configuration="CommunicationManager.xml"/>
 *   <service class="org.u2sa.core.estimation.PassThroughStateEstimator" configuration="StateEstimator.xml"/>
 * </system>
 * }</pre>
 *
 * @param file where it was read
 * @param systemId the vehicle's ID
 * @param communication the Communication Manager's configuration file; without one, its defaults
 *     hold
 * @param services in the order in which they are started
 */
public record SystemFile(
    Path file, String systemId, Optional<Path> communication, List<Entry> services) {
  /**
   * One service.
   *
   * @param className its class, with a public constructor that takes a ServiceContext
   * @param configuration its configuration file; without one, the defaults of its variables hold
   * @param element where the file says so, for error messages
   */
  public record Entry(String className, Optional<Path> configuration, XmlElement element) {
    /** The class's name without its package or enclosing class. */
    public String simpleName() {
      return className.substring(
          Math.max(className.lastIndexOf('.'), className.lastIndexOf('$')) + 1);
    }
  }

  public SystemFile {
    services = List.copyOf(services);
  }

  /**
   * Reads a system file. Paths in it are relative to its own folder.
   *
   * @throws org.u2sa.interfaces.BadInputException if it is missing, malformed or contradictory;
   *     names file, line and element
   */
  public static SystemFile read(Path file) {
    XmlElement root = XmlReader.read(file, "system");
    root.refuseUnknownAttributes("id");
    root.refuseUnknownChildren("communication", "service");
    String id = root.attribute("id");
    try {
      Topic.checkSystemId(id);
    } catch (IllegalArgumentException e) {
      throw root.error("id: " + e.getMessage());
    }
    List<XmlElement> communication = root.children("communication");
    if (communication.size() > 1) {
      throw communication
          .get(1)
          .error("a system has one Communication Manager, but this is the second");
    }
    List<Entry> services = new ArrayList<>();
    for (XmlElement element : root.children("service")) {
      element.refuseUnknownAttributes("class", "configuration");
      services.add(new Entry(element.attribute("class"), configuration(file, element), element));
    }
    if (services.isEmpty()) {
      throw root.error(
          "lists no service; expected at least one <service class=\"…\" configuration=\"…\"/>");
    }
    Optional<Path> manager =
        communication.isEmpty() ? Optional.empty() : configuration(file, communication.get(0));
    return new SystemFile(file, id, manager, services);
  }

  /**
   * The same system with one of its services only.
   *
   * @param simpleName of the service's class
   * @throws BadInputException if the file lists no such service
   */
  public SystemFile only(String simpleName) {
    for (Entry entry : services) {
      if (entry.simpleName().equals(simpleName)) {
        return new SystemFile(file, systemId, communication, List.of(entry));
      }
    }
    List<String> known = new ArrayList<>();
    services.forEach(entry -> known.add(entry.simpleName()));
    throw new BadInputException(
        file + ": lists no service \"" + simpleName + "\"; expected one of " + known);
  }

  /** The same system with its Communication Manager only. */
  public SystemFile withoutServices() {
    return new SystemFile(file, systemId, communication, List.of());
  }

  private static Optional<Path> configuration(Path file, XmlElement element) {
    Optional<String> named = element.optionalAttribute("configuration");
    if (named.isEmpty()) {
      return Optional.empty();
    }
    Path path = file.resolveSibling(named.get());
    if (!Files.isRegularFile(path)) {
      throw element.error("configuration \"" + named.get() + "\": there is no file " + path);
    }
    return Optional.of(path);
  }
}
