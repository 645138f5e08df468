package org.u2sa.world.xml;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.FieldValue;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;

/** Reads the children of an object's element as fields of its class, converting units. */
final class ObjectElement {
  private static final Set<String> NOT_IN_FILES = Set.of("systemId", "timestamp");
  private static final String FRAME = "referenceFrame";
  private static final String UID = "uid";

  private ObjectElement() {}

  /**
   * Creates the object that an element describes.
   *
   * @param frame default frame
   * @param usualUid UID of an object without one
   */
  static <T extends ObjectDescription> T read(
      XmlElement element, MessageType<T> type, ReferenceFrame frame, String usualUid) {
    element.refuseUnknownAttributes();
    T object = type.create();
    object.referenceFrame(frame);
    Map<String, List<XmlElement>> byField = byField(element, type);
    fillFirst(object, type, byField); // the units of other fields depend on this
    byField.forEach((name, each) -> fill(object, type.field(name).orElseThrow(), each));
    if (!byField.containsKey(UID)) {
      object.uid(usualUid);
    }
    place(element, object, byField);
    return object;
  }

  private static <T extends ObjectDescription> Map<String, List<XmlElement>> byField(
      XmlElement element, MessageType<T> type) {
    Map<String, List<XmlElement>> byField = new LinkedHashMap<>();
    for (XmlElement child : element.children()) {
      String name =
          type.fieldByElementName(child.name())
              .map(MessageField::name)
              .filter(known -> !NOT_IN_FILES.contains(known))
              .orElseThrow(() -> unknown(child, element, type));
      byField.computeIfAbsent(name, each -> new ArrayList<>()).add(child);
    }
    return byField;
  }

  private static BadInputException unknown(
      XmlElement child, XmlElement element, MessageType<?> type) {
    List<String> names = new ArrayList<>();
    for (MessageField<?> field : type.fields()) {
      if (!NOT_IN_FILES.contains(field.name())) {
        names.add(field.name());
      }
    }
    return element.unknown(child, names);
  }

  private static <T extends ObjectDescription> void fillFirst(
      T object, MessageType<T> type, Map<String, List<XmlElement>> byField) {
    List<XmlElement> frame = byField.remove(FRAME);
    if (frame != null) {
      fill(object, type.field(FRAME).orElseThrow(), frame);
    }
  }

  private static <T extends ObjectDescription> void fill(
      T object, MessageField<T> field, List<XmlElement> elements) {
    XmlElement first = elements.get(0);
    if (elements.size() > 1) {
      throw elements
          .get(1)
          .error("appears twice; " + field.name() + " is already in line " + first.line());
    }
    try {
      if (field.kind() == Kind.POINT_LIST) {
        field.set(object, points(first, object.referenceFrame()));
        return;
      }
      first.refuseUnknownChildren();
      first.refuseUnknownAttributes("unit");
      if (first.text().isEmpty()) {
        throw first.error("is empty; expected a value");
      }
      if (field.kind() == Kind.DOUBLE) {
        String unit = field.unitIn(object.referenceFrame());
        field.set(object, XmlNumbers.converted(first, unit, unit));
      } else if (first.optionalAttribute("unit").isPresent()) {
        throw first.error("has a unit, but " + field.name() + " is not a number");
      } else {
        field.setText(object, first.text());
      }
    } catch (BadInputException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw first.error(e.getMessage(), e);
    }
  }

  /** Reads points from {@code <point>} children or from text such as {@code 4 8; 5 9 0.5}. */
  private static List<Point> points(XmlElement element, ReferenceFrame frame) {
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("point");
    List<Point> points = new ArrayList<>();
    for (XmlElement child : element.children()) {
      points.add(point(child, frame));
    }
    for (String text : element.text().split(";")) {
      if (!text.trim().isEmpty()) {
        points.add(point(element, text.trim(), frame));
      }
    }
    if (points.isEmpty()) {
      throw element.error("contains no points; expected <point>x y</point>, or 4 8; 5 9");
    }
    return points;
  }

  private static Point point(XmlElement element, ReferenceFrame frame) {
    if (element.children().isEmpty()) {
      element.refuseUnknownAttributes();
      return point(element, element.text(), frame);
    }
    element.refuseUnknownAttributes();
    element.refuseUnknownChildren("x", "y", "z");
    String across = frame.equals(ReferenceFrame.GLOBAL) ? "deg" : "m";
    return checked(
        element,
        Point.of(
            coordinate(element, "x", across),
            coordinate(element, "y", across),
            element.child("z").isPresent() ? coordinate(element, "z", "m") : 0.0),
        frame);
  }

  private static double coordinate(XmlElement point, String name, String unit) {
    XmlElement element =
        point
            .child(name)
            .orElseThrow(() -> point.error("lacks <" + name + ">; expected x, y and optionally z"));
    element.refuseUnknownChildren();
    element.refuseUnknownAttributes("unit");
    return XmlNumbers.converted(element, unit, unit);
  }

  private static Point point(XmlElement element, String text, ReferenceFrame frame) {
    String[] parts = text.split("[\\s,]+");
    if (parts.length < 2 || parts.length > 3) {
      throw element.error("\"" + text + "\" is not a point; expected two or three numbers");
    }
    try {
      return checked(
          element,
          Point.of(
              Double.parseDouble(parts[0]),
              Double.parseDouble(parts[1]),
              parts.length == 3 ? Double.parseDouble(parts[2]) : 0.0),
          frame);
    } catch (NumberFormatException e) {
      throw element.error("\"" + text + "\" is not a point; expected two or three numbers", e);
    } catch (BadInputException e) {
      throw e;
    } catch (IllegalArgumentException e) {
      throw element.error(e.getMessage(), e); // infinite
    }
  }

  private static Point checked(XmlElement element, Point point, ReferenceFrame frame) {
    if (frame.equals(ReferenceFrame.GLOBAL)) {
      XmlNumbers.checkLongitude(element, point.x());
      XmlNumbers.checkLatitude(element, point.y());
    }
    return point;
  }

  /** Sets the centre to the mean of the points if the file gives none. */
  private static void place(
      XmlElement element, ObjectDescription object, Map<String, List<XmlElement>> byField) {
    boolean hasX = byField.containsKey("x");
    boolean hasY = byField.containsKey("y");
    if (hasX != hasY) {
      throw element.error("lacks <" + (hasX ? "y" : "x") + ">; expected both or neither");
    }
    if (!hasX) {
      Point middle = middle(element, object);
      object.x(middle.x()).y(middle.y());
      if (!byField.containsKey("z")) {
        object.z(middle.z());
      }
    } else if (object.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
      XmlNumbers.checkLongitude(byField.get("x").get(0), object.x());
      XmlNumbers.checkLatitude(byField.get("y").get(0), object.y());
    }
  }

  private static Point middle(XmlElement element, ObjectDescription object) {
    List<?> points =
        object.enumerateFields().stream()
            .filter(field -> field.name().equals("points"))
            .findFirst()
            .flatMap(FieldValue::value)
            .map(value -> (List<?>) value)
            .orElse(List.of());
    if (points.isEmpty()) {
      throw element.error("lacks <x> and <y>; expected the object's centre");
    }
    boolean onTheEarth = object.referenceFrame().equals(ReferenceFrame.GLOBAL);
    double first = ((Point) points.get(0)).x();
    double x = onTheEarth ? first : 0.0;
    double y = 0.0;
    double z = 0.0;
    for (Object each : points) {
      Point point = (Point) each;
      x += (onTheEarth ? shortWay(point.x() - first) : point.x()) / points.size();
      y += point.y() / points.size();
      z += point.z() / points.size();
    }
    return Point.of(onTheEarth ? shortWay(x) : x, y, z);
  }

  /** Wraps a longitude or a difference to ±180°: objects may cross the date line. */
  private static double shortWay(double longitudeDeg) {
    return Math.IEEEremainder(longitudeDeg, 360.0);
  }
}
