package org.toqa.notices;

/**
 * Somebody who can be told by letter.
 *
 * @param id of his account, which may sign in
 * @param email the account's address
 */
public record Person(long id, String email, NoticePreferences preferences) {}
