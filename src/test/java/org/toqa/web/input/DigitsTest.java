package org.toqa.web.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DigitsTest {
  @ParameterizedTest
  @CsvSource({
    "2.5, 2.5",
    "٢٫٥, 2.5",
    "٠١٢٣٤٥٦٧٨٩, 0123456789",
    "۰۱۲۳۴۵۶۷۸۹, 0123456789",
    "-۱۰٫۵, -10.5",
    "'\u200E-1.25 ', -1.25",
    "१२, १२",
    "٢٬٥, 2٬5",
    "east, east"
  })
  void numbersOfTheArabicScriptAreReadAsThoseOfTheLatinOne(String typed, String latin) {
    assertEquals(latin, Digits.latin(typed));
  }

  @ParameterizedTest
  @CsvSource({
    "'2,5', 2.5",
    "'-10,25', -10.25",
    "'٢,٥', 2.5",
    "2.5, 2.5",
    "'1,000',",
    "'1,2,3',",
    "',5',",
    "1e3,",
    "'1,5E2',"
  })
  void aCommaThatCanOnlyBeADecimalOneIsOneInAForm(String typed, @Nullable Double number) {
    assertEquals(Optional.ofNullable(number), Digits.enteredNumber(typed));
  }
}
