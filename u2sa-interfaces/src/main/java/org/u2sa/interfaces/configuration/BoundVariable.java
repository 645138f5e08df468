package org.u2sa.interfaces.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.units.NumberText;
import org.u2sa.interfaces.units.Units;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * A variable with its declaration, its file entry, or both. Values and limits are in the declared
 * unit, or in the file's if undeclared.
 */
final class BoundVariable {
  /** Rounding tolerance between a converted and the declared limit. */
  private static final double ROUNDING = 1.0e-9;

  private final String origin;
  private final String name;
  private final Optional<VariableDeclaration<?>> declared;
  private final Optional<FileVariable> stated;
  private final VariableType type;
  private final Range limits;

  /**
   * @throws ConfigurationException if declaration and file disagree in type, unit or limits
   */
  BoundVariable(
      String origin,
      String name,
      Optional<VariableDeclaration<?>> declared,
      Optional<FileVariable> stated) {
    this.origin = origin;
    this.name = name;
    this.declared = declared;
    this.stated = stated;
    type = declared.map(VariableDeclaration::type).orElseGet(() -> stated.get().type());
    if (stated.isPresent() && type != stated.get().type()) {
      throw error("type is " + stated.get().type().xmlName() + ", expected " + type.xmlName());
    }
    requireUsableUnit();
    limits = narrowedLimits();
  }

  private String unit() {
    return declared.map(VariableDeclaration::unit).orElseGet(this::fileUnit);
  }

  private String description() {
    return declared
        .map(VariableDeclaration::description)
        .filter(text -> !text.isEmpty())
        .orElseGet(() -> stated.map(FileVariable::description).orElse(""));
  }

  /**
   * Value from the file, else the declared default.
   *
   * @throws ConfigurationException if both are missing, or the value is invalid
   */
  Object value() {
    if (!stated.isPresent()) {
      return declared
          .flatMap(VariableDeclaration::ifAbsent)
          .map(Object.class::cast)
          .orElseThrow(() -> error("is required and missing; expected " + expected()));
    }
    Object value = stated.get().value();
    if (value instanceof Double number && converts()) {
      double converted = fromFile(number);
      value = near(converted, limits.min()) ? limits.min() : converted;
      value = near(converted, limits.max()) ? limits.max() : value;
    }
    Object checked = value;
    refusal(checked).ifPresent(this::refuse);
    return checked;
  }

  /**
   * Parses and validates.
   *
   * @throws ConfigurationException if the value is invalid
   */
  Object checked(Object value) {
    Object typed;
    try {
      typed = type.convert(value);
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(place() + e.getMessage(), e);
    }
    refusal(typed)
        .ifPresent(
            reason -> {
              throw error(reason);
            });
    return typed;
  }

  FileVariable restated(Object value) {
    FileVariable before =
        stated.orElseGet(
            () ->
                new FileVariable(
                    origin,
                    name,
                    type,
                    "",
                    value,
                    unit().isEmpty() ? Optional.empty() : Optional.of(unit()),
                    Range.any(),
                    ""));
    return before.withText(fileText(value));
  }

  ConfigurationVariable described(Object value) {
    ConfigurationVariable message =
        new ConfigurationVariable()
            .name(name)
            .variableType(type.xmlName())
            .value(String.valueOf(value))
            .unit(unit())
            .description(description());
    List<String> choices = new ArrayList<>();
    declared.ifPresent(
        variable -> variable.choices().forEach(choice -> choices.add(String.valueOf(choice))));
    if (!choices.isEmpty()) {
      message.choices(choices);
    }
    if (limits.min() != Double.NEGATIVE_INFINITY) {
      message.min(limits.min());
    }
    if (limits.max() != Double.POSITIVE_INFINITY) {
      message.max(limits.max());
    }
    return message;
  }

  private String fileText(Object value) {
    return value instanceof Double number && converts()
        ? Double.toString(Units.convert(number, unit(), fileUnit()))
        : String.valueOf(value);
  }

  private ConfigurationException error(String what) {
    return new ConfigurationException(place() + what);
  }

  private String place() {
    return stated.map(FileVariable::place).orElse(origin) + ", variable \"" + name + "\": ";
  }

  private Optional<String> refusal(Object value) {
    if (value instanceof Number number && !limits.contains(number.doubleValue())) {
      return Optional.of(limits.refusal(NumberText.withUnit(value, unit()), unit()));
    }
    return declared.flatMap(variable -> variable.refusal(value));
  }

  // The message uses the file's unit, because the user wrote it.
  private void refuse(String reason) {
    if (!converts()
        || !(stated.get().value() instanceof Double number)
        || limits.contains(fromFile(number))) {
      throw error(reason);
    }
    throw error(
        inFile(limits).refusal(NumberText.withUnit(stated.get().value(), fileUnit()), fileUnit()));
  }

  private String expected() {
    VariableDeclaration<?> variable = declared.get();
    StringBuilder text = new StringBuilder(variable.type().xmlName());
    text.append(unit().isEmpty() ? "" : " in " + unit());
    text.append(limits.isAny() ? "" : ", " + limits);
    text.append(variable.choices().isEmpty() ? "" : ", one of " + variable.choicesText());
    return text.append(description().isEmpty() ? "" : " (" + description() + ")").toString();
  }

  private void requireUsableUnit() {
    if (!declared.isPresent() || !converts()) {
      return;
    }
    if (unit().isEmpty()) {
      throw error("unit \"" + fileUnit() + "\" is given, but the variable has none");
    }
    if (type == VariableType.INTEGER) {
      throw error("unit is \"" + fileUnit() + "\", expected \"" + unit() + "\"");
    }
    try {
      Units.convert(0.0, fileUnit(), unit());
    } catch (IllegalArgumentException e) {
      throw new ConfigurationException(place() + e.getMessage(), e);
    }
  }

  private Range narrowedLimits() {
    Range declaredLimits = declared.map(VariableDeclaration::range).orElse(Range.any());
    if (!stated.isPresent()) {
      return declaredLimits;
    }
    double min = narrowed("min", stated.get().limits().min(), declaredLimits.min(), declaredLimits);
    double max = narrowed("max", stated.get().limits().max(), declaredLimits.max(), declaredLimits);
    return declaredLimits.between(min, max);
  }

  private double narrowed(String which, double inFile, double declaredEnd, Range declaredLimits) {
    if (Double.isInfinite(inFile)) {
      return declaredEnd;
    }
    double end = fromFile(inFile);
    if (near(end, declaredEnd)) {
      return declaredEnd;
    }
    if (!declaredLimits.contains(end)) {
      throw error(
          which
              + " "
              + inFile(declaredLimits)
                  .refusal(
                      NumberText.withUnit(inFile, fileUnit()), converts() ? fileUnit() : unit())
              + "; a file may narrow the range, not widen it");
    }
    return end;
  }

  private static boolean near(double value, double end) {
    return Double.isFinite(end) && Math.abs(value - end) <= ROUNDING * Math.abs(end);
  }

  private String fileUnit() {
    return stated.flatMap(FileVariable::unit).orElse("");
  }

  private boolean converts() {
    return !fileUnit().isEmpty() && !fileUnit().equals(unit());
  }

  private double fromFile(double value) {
    return converts() ? Units.convert(value, fileUnit(), unit()) : value;
  }

  private Range inFile(Range range) {
    return converts()
        ? range.between(
            Units.convert(range.min(), unit(), fileUnit()),
            Units.convert(range.max(), unit(), fileUnit()))
        : range;
  }
}
