package org.u2sa.interfaces.configuration;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Parameter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Binds a record's {@link Variable} components to configuration variables. Uses the canonical
 * constructor, because Android lacks record components.
 */
final class RecordBinding<T> {
  private final Constructor<T> constructor;
  private final List<VariableDeclaration<?>> declarations = new ArrayList<>();

  private RecordBinding(Constructor<T> constructor, String prefix) {
    this.constructor = constructor;
    constructor.setAccessible(true);
    for (Parameter parameter : constructor.getParameters()) {
      declarations.add(declaration(parameter, prefix));
    }
  }

  /**
   * @param prefix prefix of each variable's name
   * @throws IllegalArgumentException if it is not a record of correctly declared variables; names
   *     the first invalid one
   */
  static <T> RecordBinding<T> of(Class<T> type, String prefix) {
    return in(type, prefix)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    type.getName()
                        + ": expected a record whose components all have @"
                        + Variable.class.getSimpleName()));
  }

  @SuppressWarnings("unchecked") // constructors of a class create its instances
  private static <T> Optional<RecordBinding<T>> in(Class<T> type, String prefix) {
    return Arrays.stream(type.getDeclaredConstructors())
        .filter(each -> each.getParameterCount() > 0)
        .filter(
            each ->
                Arrays.stream(each.getParameters())
                    .allMatch(parameter -> parameter.isAnnotationPresent(Variable.class)))
        .findFirst()
        .map(each -> new RecordBinding<>((Constructor<T>) each, prefix));
  }

  List<VariableDeclaration<?>> declarations() {
    return declarations;
  }

  /**
   * Creates the record from individually valid values.
   *
   * @throws IllegalArgumentException if it rejects the combination
   */
  T bind(Map<String, Object> values) {
    Parameter[] parameters = constructor.getParameters();
    Object[] arguments = new Object[parameters.length];
    for (int i = 0; i < arguments.length; i++) {
      Object value = values.get(declarations.get(i).name());
      Class<?> type = parameters[i].getType();
      arguments[i] = type.isEnum() ? constant(type, (String) value) : value;
    }
    try {
      return constructor.newInstance(arguments);
    } catch (InvocationTargetException e) {
      if (e.getCause() instanceof RuntimeException refusal) {
        throw refusal;
      }
      throw new IllegalStateException(constructor + " failed", e.getCause());
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(constructor + " cannot be called", e);
    }
  }

  private static Object constant(Class<?> type, String name) {
    return Arrays.stream(type.getEnumConstants())
        .filter(each -> ((Enum<?>) each).name().equals(name))
        .findFirst()
        .orElseThrow(); // choices are the enum's constants
  }

  private VariableDeclaration<?> declaration(Parameter parameter, String prefix) {
    Variable said = parameter.getAnnotation(Variable.class);
    try {
      return declaration(said, prefix + name(said, parameter), parameter.getType())
          .describedAs(description(said, parameter));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          constructor.getDeclaringClass().getName() + ": " + e.getMessage(), e);
    }
  }

  private static String description(Variable said, Parameter parameter) {
    Description description = parameter.getAnnotation(Description.class);
    if (description == null) {
      throw new IllegalArgumentException(said + ": expected a @Description");
    }
    return description.value();
  }

  private static String name(Variable said, Parameter parameter) {
    if (!said.name().isEmpty()) {
      return said.name();
    }
    if (!parameter.isNamePresent()) {
      throw new IllegalArgumentException(
          said + ": expected a name, or compilation with -parameters");
    }
    return parameter.getName().replaceAll("(?<=[a-z0-9])(?=[A-Z])", " ").toUpperCase(Locale.ROOT);
  }

  private static VariableDeclaration<?> declaration(Variable said, String name, Class<?> type) {
    boolean number = type == double.class || type == int.class;
    boolean hasNumber = !Double.isNaN(said.ifAbsent());
    boolean hasText = !said.ifAbsentText().equals(Variable.REQUIRED);
    if (number ? hasText : hasNumber) {
      throw wrong(name, (number ? "ifAbsentText" : "ifAbsent") + " does not fit " + type);
    }
    if (type != String.class && said.oneOf().length > 0) {
      throw wrong(name, "oneOf is for texts, not for " + type);
    }
    if (!number && (!range(said).isAny() || !said.unit().isEmpty())) {
      throw wrong(name, "min, max and unit are for numbers, not for " + type);
    }
    if (type == double.class) {
      VariableDeclaration<Double> declared =
          VariableDeclaration.number(name, said.unit()).range(range(said));
      return hasNumber ? declared.ifAbsent(said.ifAbsent()) : declared;
    }
    if (type == int.class) {
      VariableDeclaration<Integer> declared =
          VariableDeclaration.integer(name, said.unit()).range(range(said));
      return hasNumber ? declared.ifAbsent(whole(name, said.ifAbsent())) : declared;
    }
    if (type == boolean.class) {
      VariableDeclaration<Boolean> declared = VariableDeclaration.flag(name);
      return hasText
          ? declared.ifAbsent((Boolean) VariableType.BOOLEAN.parse(said.ifAbsentText()))
          : declared;
    }
    if (type != String.class && !type.isEnum()) {
      throw wrong(name, type + " is neither double, int, boolean, String nor an enum");
    }
    VariableDeclaration<String> declared =
        VariableDeclaration.text(name).oneOf(type.isEnum() ? names(type) : said.oneOf());
    return hasText ? declared.ifAbsent(said.ifAbsentText()) : declared;
  }

  private static Range range(Variable said) {
    return said.minExcluded()
        ? Range.above(said.min(), said.max())
        : Range.of(said.min(), said.max());
  }

  private static int whole(String name, double value) {
    if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE) {
      throw wrong(name, "ifAbsent " + value + " is not a whole number");
    }
    return (int) value;
  }

  private static String[] names(Class<?> type) {
    return Arrays.stream(type.getEnumConstants())
        .map(each -> ((Enum<?>) each).name())
        .toArray(String[]::new);
  }

  private static IllegalArgumentException wrong(String name, String why) {
    return new IllegalArgumentException("variable \"" + name + "\": " + why);
  }
}
