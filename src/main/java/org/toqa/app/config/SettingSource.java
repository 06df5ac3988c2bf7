package org.toqa.app.config;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.yaml.Spelling;
import org.toqa.yaml.YamlParser;
import org.toqa.yaml.YamlSyntaxException;

/** The settings that one source gives: the command line, the environment or a file. */
public final class SettingSource {
  private static final String PREFIX = "TOQA_";

  /** The variable that names the file, and so is no setting itself. */
  public static final String FILE_ENVIRONMENT_VARIABLE = PREFIX + "CONFIG";

  /** How far a name may be from a known one to be taken for a misspelt one. */
  private static final int MAX_TYPO_DISTANCE = 2;

  /**
   * @param origin where it was written, for a sentence
   * @param folder from which a relative path counts
   */
  record Value(String text, String origin, Path folder) {}

  private final Map<Setting, Value> values = new EnumMap<>(Setting.class);

  /** By names that they had once, for where the new name gives none. */
  private final Map<Setting, Value> old = new EnumMap<>(Setting.class);

  private SettingSource() {}

  @Nullable Value value(Setting setting) {
    Value value = values.get(setting);
    return value == null ? old.get(setting) : value;
  }

  /** From options; those that were not given are null. */
  public static SettingSource fromCommandLine(Map<Setting, @Nullable String> options) {
    SettingSource layer = new SettingSource();
    options.forEach(
        (setting, text) -> {
          if (text != null) {
            layer.values.put(setting, new Value(text, setting.commandLineOption(), Path.of("")));
          }
        });
    return layer;
  }

  /**
   * From the {@code TOQA_} variables. Unknown ones are ignored.
   *
   * @throws ConfigurationException the name of one is nearly that of a setting; suggests it
   */
  public static SettingSource fromEnvironment(Map<String, String> environment)
      throws ConfigurationException {
    SettingSource layer = new SettingSource();
    Map<String, Setting> known = new TreeMap<>();
    for (Setting setting : Setting.values()) {
      known.put(setting.environmentVariable(), setting);
    }
    for (Map.Entry<String, String> entry : environment.entrySet()) {
      String variable = entry.getKey();
      Setting setting = known.get(variable);
      Value value = new Value(entry.getValue(), variable, Path.of(""));
      if (setting != null) {
        layer.values.put(setting, value);
      } else if (Setting.byOldEnvironmentVariable(variable).isPresent()) {
        layer.old.put(Setting.byOldEnvironmentVariable(variable).get(), value);
      } else if (variable.startsWith(PREFIX) && !variable.equals(FILE_ENVIRONMENT_VARIABLE)) {
        Spelling.Suggestion nearest = Spelling.nearest(variable, known.keySet());
        if (nearest.distance() <= MAX_TYPO_DISTANCE) {
          throw new ConfigurationException(
              "The environment variable "
                  + variable
                  + " is unknown; do you mean "
                  + nearest.word()
                  + "?");
        }
      }
    }
    return layer;
  }

  /**
   * From a YAML file; relative paths in it count from its folder.
   *
   * @throws ConfigurationException the file cannot be read, is no YAML, or has an unknown key; says
   *     where
   */
  public static SettingSource fromFile(Path file) throws ConfigurationException {
    SettingSource layer = new SettingSource();
    if (parse(file) instanceof Map<?, ?> map) {
      layer.readKeys(file, "", map);
    } else {
      throw new ConfigurationException(file + ": must be lines of the form \"key: value\".");
    }
    return layer;
  }

  private static Object parse(Path file) throws ConfigurationException {
    try {
      Object root = YamlParser.parse(Files.readString(file));
      return root == null ? Map.of() : root;
    } catch (NoSuchFileException e) {
      throw new ConfigurationException(file + ": there is no such file.");
    } catch (CharacterCodingException e) {
      throw new ConfigurationException(file + ": is no UTF-8 text.");
    } catch (IOException e) {
      throw new ConfigurationException(file + ": cannot be read (" + e.getMessage() + ").");
    } catch (YamlSyntaxException e) {
      throw new ConfigurationException(
          e.line().isPresent()
              ? "%s, line %d: %s.".formatted(file, e.line().getAsInt(), e.problem())
              : file + ": is no YAML (" + e.problem() + ").");
    }
  }

  private void readKeys(Path file, String prefix, Map<?, ?> map) throws ConfigurationException {
    for (Map.Entry<?, ?> entry : map.entrySet()) {
      String key = prefix + entry.getKey();
      if (entry.getValue() instanceof Map<?, ?> nested && isGroup(key)) {
        readKeys(file, key + ".", nested);
        continue;
      }
      Setting setting =
          Setting.byKey(key)
              .or(() -> Setting.byOldKey(key))
              .orElseThrow(() -> new ConfigurationException(unknownKeyMessage(file, key)));
      Object value = entry.getValue();
      if (value == null || value instanceof Map || value instanceof Iterable) {
        throw new ConfigurationException(
            file + ": " + key + " needs one value, " + setting.allowedValues() + ".");
      }
      Path folder = file.toAbsolutePath().getParent();
      Map<Setting, Value> into = setting.key().equals(key) ? values : old;
      into.put(
          setting,
          new Value(value.toString(), key + " in " + file, folder == null ? Path.of("") : folder));
    }
  }

  private static boolean isGroup(String key) {
    return keys().stream().anyMatch(k -> k.startsWith(key + "."));
  }

  private static String unknownKeyMessage(Path file, String key) {
    return file
        + ": the key "
        + key
        + " is unknown"
        + Spelling.near(key, keys()).map(near -> "; the nearest is " + near).orElse("")
        + ".";
  }

  private static List<String> keys() {
    return Arrays.stream(Setting.values()).map(Setting::key).sorted().toList();
  }
}
