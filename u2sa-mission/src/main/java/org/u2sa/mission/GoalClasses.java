package org.u2sa.mission;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.schema.Kind;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Describes the classes of goals that mission files may contain. */
final class GoalClasses {
  /** Kinds of values with an XML form, and their names in descriptions. */
  private static final Map<Kind, String> KINDS = new EnumMap<>(Kind.class);

  static {
    KINDS.put(Kind.DOUBLE, "double");
    KINDS.put(Kind.LONG, "int");
    KINDS.put(Kind.BOOLEAN, "boolean");
    KINDS.put(Kind.STRING, "string");
    KINDS.put(Kind.ENUM, "string");
    KINDS.put(Kind.FRAME, "string");
    KINDS.put(Kind.STRING_LIST, "texts");
    KINDS.put(Kind.POINT, "point");
    KINDS.put(Kind.POINT_LIST, "points");
  }

  private GoalClasses() {}

  /**
   * All goal classes known to this process, including those from jars, by name.
   *
   * @param manager the Mission Manager's name
   */
  static List<GoalClass> of(MessageTypes types, String manager) {
    return types.all().stream()
        .filter(type -> GoalInformation.class.isAssignableFrom(type.messageClass()))
        .filter(type -> !type.isAbstract())
        .map(type -> described(type).serviceName(manager))
        .sorted(Comparator.comparing(GoalClass::className))
        .collect(Collectors.toList());
  }

  private static <T extends U2SAData> GoalClass described(MessageType<T> type) {
    T empty = type.create();
    List<ConfigurationVariable> variables = new ArrayList<>();
    List<String> required = new ArrayList<>();
    for (MessageField<T> field : type.fields()) {
      if (KINDS.containsKey(field.kind()) && !GoalElement.NOT_IN_FILES.contains(field.name())) {
        variables.add(described(field, empty));
        if (field.isRequired() && !GoalElement.SET_LATER.contains(field.name())) {
          required.add(field.name());
        }
      }
    }
    return new GoalClass().className(type.name()).variables(variables).required(required);
  }

  private static <T extends U2SAData> ConfigurationVariable described(
      MessageField<T> field, T empty) {
    ConfigurationVariable variable =
        new ConfigurationVariable()
            .name(field.name())
            .variableType(KINDS.get(field.kind()))
            .unit(field.unitIn(ReferenceFrame.GLOBAL));
    field
        .get(empty)
        .filter(value -> !(value instanceof List))
        .ifPresent(value -> variable.value(value.toString()));
    if (field instanceof NumberField<T> number) {
      if (number.min() > -Limits.COORDINATE) {
        variable.min(number.min());
      }
      if (number.max() < Limits.COORDINATE) {
        variable.max(number.max());
      }
    } else if (field.kind() == Kind.ENUM) {
      List<?> constants = ((ValueField<T, ?>) field).constants();
      variable.choices(constants.stream().map(Object::toString).collect(Collectors.toList()));
    }
    return variable;
  }
}
