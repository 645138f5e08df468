package org.u2sa.world.xml;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.world.sdf.SdfWorld;

/**
 * A world read from a file (docs/world-model.md): {@code <world>} with an element for each object,
 * named after its class (thesis 3.2.3.3), at most one {@code <environment>}, movers and zones. All
 * objects have unique UIDs and are frozen.
 */
public final class WorldFile {
  private static final String REFERENCE = "reference";
  private static final String ENVIRONMENT = "environment";

  private static final String MOVER = "mover";
  private static final String ZONE = "zone";
  private static final int MAX_SCRIPTED = 1_000; // of movers and of zones
  private static final Map<String, List<String>> SCRIPTS =
      Map.of(
          MOVER,
          List.of("waypoint", "speed", "end", "delay", "floats", "transponder"),
          ZONE,
          List.of("kind", "surface"));

  private final List<ObjectDescription> objects;
  private final List<Scripted> movers;
  private final List<Scripted> zones;
  private final Optional<XmlElement> environment;
  private final List<String> ignored;
  private final List<String> missing;

  /**
   * An object in an element that simulations read.
   *
   * @param element a mover or zone
   * @param object the object in it
   */
  public record Scripted(XmlElement element, ObjectDescription object) {}

  private WorldFile(
      List<ObjectDescription> objects,
      List<Scripted> movers,
      List<Scripted> zones,
      Optional<XmlElement> environment,
      List<String> ignored,
      List<String> missing) {
    this.objects = List.copyOf(objects);
    this.movers = List.copyOf(movers);
    this.zones = List.copyOf(zones);
    this.environment = environment;
    this.ignored = List.copyOf(ignored);
    this.missing = List.copyOf(missing);
  }

  /**
   * Reads a world with all classes of objects on the class path.
   *
   * @throws org.u2sa.interfaces.BadInputException naming file, line, element, value and what was
   *     expected
   */
  public static WorldFile load(Path file) {
    return load(file, MessageTypes.discovered());
  }

  /**
   * Reads a world, or a world of Gazebo if the file is named {@code .sdf} or {@code .world}.
   *
   * @param types message types in which object classes are looked up
   * @throws org.u2sa.interfaces.BadInputException see {@link #load(Path)}
   */
  public static WorldFile load(Path file, MessageTypes types) {
    if (SdfWorld.isSdf(file)) {
      SdfWorld sdf = SdfWorld.read(file, System.getenv());
      return new WorldFile(
          sdf.objects(), List.of(), List.of(), Optional.empty(), sdf.ignored(), sdf.missing());
    }
    return parse(XmlReader.read(file, "world"), types);
  }

  public static WorldFile parse(XmlElement root, MessageTypes types) {
    root.refuseUnknownAttributes();
    ReferenceFrame frame =
        root.child(REFERENCE).map(WorldFile::frame).orElse(ReferenceFrame.GLOBAL);
    Map<String, XmlElement> byUid = new LinkedHashMap<>();
    List<ObjectDescription> objects = new ArrayList<>();
    Map<String, List<Scripted>> scripted = new LinkedHashMap<>();
    SCRIPTS.keySet().forEach(name -> scripted.put(name, new ArrayList<>()));
    for (XmlElement child : root.children()) {
      List<Scripted> like = scripted.get(child.name());
      if (like != null) {
        if (like.size() == MAX_SCRIPTED) {
          throw child.error("is one too many; expected at most " + MAX_SCRIPTED);
        }
        XmlElement shape = shape(child, types);
        String number = child.name() + " " + (like.size() + 1);
        like.add(new Scripted(child, object(shape, types, frame, number, byUid)));
      } else if (!child.name().equals(REFERENCE) && !child.name().equals(ENVIRONMENT)) {
        String number = type(child, types, List.of()).name() + " " + (objects.size() + 1);
        objects.add(object(child, types, frame, number, byUid));
      }
    }
    return new WorldFile(
        objects,
        scripted.get(MOVER),
        scripted.get(ZONE),
        root.child(ENVIRONMENT),
        List.of(),
        List.of());
  }

  private static ObjectDescription object(
      XmlElement element,
      MessageTypes types,
      ReferenceFrame frame,
      String name,
      Map<String, XmlElement> byUid) {
    ObjectDescription object =
        ObjectElement.read(element, type(element, types, List.of()), frame, name);
    XmlElement other = byUid.putIfAbsent(object.uid(), element);
    if (other != null) {
      throw element.error(
          "the object in line "
              + other.line()
              + " has the uid \""
              + object.uid()
              + "\" already; UIDs must be unique");
    }
    object.freeze();
    return object;
  }

  /** The only child of a mover or zone that is an object. */
  private static XmlElement shape(XmlElement element, MessageTypes types) {
    element.refuseUnknownAttributes();
    element.refuseText();
    List<String> script = SCRIPTS.get(element.name());
    List<XmlElement> shapes =
        element.children().stream()
            .filter(child -> !script.contains(child.name()))
            .collect(Collectors.toList());
    shapes.forEach(child -> type(child, types, script)); // rejects other elements
    if (shapes.size() != 1) {
      throw element.error("holds " + shapes.size() + " objects; expected one, such as <box>");
    }
    return shapes.get(0);
  }

  private static ReferenceFrame frame(XmlElement element) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren();
    try {
      return ReferenceFrame.parse(element.text());
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e);
    }
  }

  private static MessageType<? extends ObjectDescription> type(
      XmlElement element, MessageTypes types, List<String> besides) {
    List<String> names = new ArrayList<>(besides);
    for (MessageType<?> type : types.all()) {
      if (isObject(type)) {
        names.add(type.name());
      }
    }
    return types
        .byElementName(element.name())
        .filter(WorldFile::isObject)
        .map(WorldFile::asObject)
        .orElseThrow(
            () ->
                element.error(
                    "is not a class of objects; expected one of "
                        + String.join(", ", names)
                        + NearestNames.didYouMean(element.name(), names)));
  }

  private static boolean isObject(MessageType<?> type) {
    return ObjectDescription.class.isAssignableFrom(type.messageClass()) && !type.isAbstract();
  }

  @SuppressWarnings("unchecked") // isObject has compared the message class
  private static MessageType<? extends ObjectDescription> asObject(MessageType<?> type) {
    return (MessageType<? extends ObjectDescription>) type;
  }

  /** The objects in the order of the file. */
  public List<ObjectDescription> objects() {
    return objects;
  }

  /** Objects that move in simulations, with their scripts. */
  public List<Scripted> movers() {
    return movers;
  }

  /** Named areas of simulations. */
  public List<Scripted> zones() {
    return zones;
  }

  /** Terrain, surface, water, wind and light, which simulations read; empty if there is none. */
  public Optional<XmlElement> environment() {
    return environment;
  }

  /** Elements of a Gazebo world that do not become objects, and why. */
  public List<String> ignored() {
    return ignored;
  }

  /** Those of {@link #ignored()} that may stand in the way, such as models that are not found. */
  public List<String> missing() {
    return missing;
  }

  /** Object with the given UID; empty if none. */
  public Optional<ObjectDescription> object(String uid) {
    return objects.stream().filter(object -> object.uid().equals(uid)).findFirst();
  }
}
