package org.toqa.allocation;

/** Why a robot does not carry a load. */
public enum Impediment {
  /** Only others may have it. */
  NOT_CHOSEN,
  TOO_WEAK,
  NO_PATH,
  /** It would not get to a charger after it. */
  BATTERY,
  /** Its agent declined for what only it knows, or refused what it was awarded. */
  DECLINED,
  /** Its agent has not answered in time. */
  SILENT
}
