package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.units.XmlNumbers;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;

/**
 * A goal with its XML elements, so that errors can name the line.
 *
 * @param element the goal's own
 * @param fields elements of its fields, by field name
 * @param links its links to following goals
 */
record GoalElement(
    XmlElement element, GoalInformation message, Map<String, XmlElement> fields, GoalLinks links) {
  /** Message fields that are absent in files or written differently. */
  static final List<String> NOT_IN_FILES =
      Arrays.asList(
          "systemId",
          "timestamp",
          "completed",
          "abandoned",
          "result",
          "reason",
          "arrivedAt",
          "nextIfDone",
          "nextIfFailed",
          "nextIfTimedOut",
          "repeatFrom",
          "repeatTimes");

  /** Required fields that the Mission Manager sets if a file omits them. */
  static final List<String> SET_LATER = Arrays.asList("uid", "horizontalThreshold");

  private static final String FRAME = "referenceFrame";

  /**
   * Reads the children of a goal's element as fields of its class, converting units.
   *
   * @param complete whether the class's required fields must be present
   */
  static <T extends GoalInformation> GoalElement read(
      XmlElement element, MessageType<T> type, boolean complete) {
    element.refuseUnknownAttributes();
    T message = type.create();
    GoalLinks links = new GoalLinks(element);
    Map<String, List<XmlElement>> byField = byField(element, type, links);
    ReferenceFrame frame = ReferenceFrame.GLOBAL;
    if (byField.containsKey(FRAME)) { // first: the units of the others depend on it
      fill(message, type.field(FRAME).orElseThrow(), byField.get(FRAME), frame);
      frame = (ReferenceFrame) type.field(FRAME).orElseThrow().get(message).orElseThrow();
    }
    Map<String, XmlElement> fields = new LinkedHashMap<>();
    for (Map.Entry<String, List<XmlElement>> entry : byField.entrySet()) {
      fill(message, type.field(entry.getKey()).orElseThrow(), entry.getValue(), frame);
      fields.put(entry.getKey(), entry.getValue().get(0));
    }
    if (complete) {
      refuseMissing(element, type, message, frame);
    }
    links.readInto(message);
    return new GoalElement(element, message, fields, links);
  }

  private static <T extends GoalInformation> void refuseMissing(
      XmlElement element, MessageType<T> type, T message, ReferenceFrame frame) {
    for (MessageField<T> field : type.fields()) {
      if (field.isRequired() && !field.isSet(message) && !SET_LATER.contains(field.name())) {
        throw element.error("lacks <" + field.name() + ">; expected " + expected(field, frame));
      }
    }
  }

  /** Copy with another goal that extends the elements' content. */
  GoalElement with(GoalInformation other) {
    return new GoalElement(element, other, fields, links);
  }

  private static <T extends GoalInformation> Map<String, List<XmlElement>> byField(
      XmlElement element, MessageType<T> type, GoalLinks links) {
    Map<String, List<XmlElement>> byField = new LinkedHashMap<>();
    for (XmlElement child : element.children()) {
      if (links.takes(child)) {
        continue;
      }
      MessageField<T> field =
          type.fieldByElementName(child.name())
              .filter(known -> !NOT_IN_FILES.contains(known.name()))
              .orElseThrow(() -> unknownField(child, element, type));
      byField.computeIfAbsent(field.name(), name -> new ArrayList<>()).add(child);
    }
    return byField;
  }

  private static RuntimeException unknownField(
      XmlElement child, XmlElement element, MessageType<?> type) {
    List<String> names = new ArrayList<>();
    for (MessageField<?> field : type.fields()) {
      if (!NOT_IN_FILES.contains(field.name())) {
        names.add(type.elementName(field));
      }
    }
    names.addAll(GoalLinks.ELEMENTS);
    return element.unknown(child, names);
  }

  private static <T extends GoalInformation> void fill(
      T message, MessageField<T> field, List<XmlElement> elements, ReferenceFrame frame) {
    XmlElement first = elements.get(0);
    if (elements.size() > 1 && field.kind() != Kind.STRING_LIST) {
      throw elements
          .get(1)
          .error("appears twice; " + field.name() + " is already in line " + first.line());
    }
    List<String> texts = new ArrayList<>();
    for (XmlElement each : elements) {
      each.refuseUnknownChildren();
      each.refuseUnknownAttributes("unit");
      if (each.text().isEmpty()) {
        throw each.error("is empty; expected " + expected(field, frame));
      }
      texts.add(each.text());
    }
    try {
      if (field.kind() == Kind.DOUBLE) {
        String unit = field.unitIn(frame);
        field.set(message, XmlNumbers.converted(first, unit, unit));
      } else if (first.optionalAttribute("unit").isPresent()) {
        throw first.error("has a unit, but " + field.name() + " is not a number");
      } else {
        field.setTexts(message, texts);
      }
    } catch (IllegalArgumentException e) {
      throw first.error(e.getMessage(), e);
    }
  }

  private static String expected(MessageField<?> field, ReferenceFrame frame) {
    String unit = field.unitIn(frame);
    return field.kind() == Kind.DOUBLE
        ? "a number" + (unit.isEmpty() ? "" : " of " + unit)
        : "a value";
  }

  /** Element of a field, by field name; empty if omitted in the file. */
  Optional<XmlElement> field(String name) {
    return Optional.ofNullable(fields.get(name));
  }
}
