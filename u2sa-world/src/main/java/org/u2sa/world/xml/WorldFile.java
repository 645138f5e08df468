package org.u2sa.world.xml;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
 * named after its class (thesis 3.2.3.3), and at most one {@code <environment>}. The objects have
 * unique UIDs and are frozen.
 */
public final class WorldFile {
  private static final String REFERENCE = "reference";
  private static final String ENVIRONMENT = "environment";

  private final List<ObjectDescription> objects;
  private final Optional<XmlElement> environment;
  private final List<String> ignored;

  private WorldFile(
      List<ObjectDescription> objects, Optional<XmlElement> environment, List<String> ignored) {
    this.objects = List.copyOf(objects);
    this.environment = environment;
    this.ignored = List.copyOf(ignored);
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
      return new WorldFile(sdf.objects(), Optional.empty(), sdf.ignored());
    }
    return parse(XmlReader.read(file, "world"), types);
  }

  public static WorldFile parse(XmlElement root, MessageTypes types) {
    root.refuseUnknownAttributes();
    ReferenceFrame frame =
        root.child(REFERENCE).map(WorldFile::frame).orElse(ReferenceFrame.GLOBAL);
    Map<String, XmlElement> byUid = new LinkedHashMap<>();
    List<ObjectDescription> objects = new ArrayList<>();
    for (XmlElement child : root.children()) {
      if (!child.name().equals(REFERENCE) && !child.name().equals(ENVIRONMENT)) {
        ObjectDescription object =
            ObjectElement.read(child, type(child, types), frame, objects.size() + 1);
        XmlElement other = byUid.putIfAbsent(object.uid(), child);
        if (other != null) {
          throw child.error(
              "the object in line "
                  + other.line()
                  + " has the uid \""
                  + object.uid()
                  + "\" already; uids must differ");
        }
        object.freeze();
        objects.add(object);
      }
    }
    return new WorldFile(objects, root.child(ENVIRONMENT), List.of());
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
      XmlElement element, MessageTypes types) {
    List<String> names = new ArrayList<>();
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
                    "is no class of objects; expected one of "
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

  /** Terrain, surface, water and wind, which simulations read; empty if there is none. */
  public Optional<XmlElement> environment() {
    return environment;
  }

  /** What a world of Gazebo holds that is no object here, and why. */
  public List<String> ignored() {
    return ignored;
  }

  /** Object with the given UID; empty if none. */
  public Optional<ObjectDescription> object(String uid) {
    return objects.stream().filter(object -> object.uid().equals(uid)).findFirst();
  }
}
