<%@ tag body-content="empty" pageEncoding="UTF-8" trimDirectiveWhitespaces="true" %>
<%-- When a task is to be put in: now, later, or again and again. The page has the field of the time zone. --%>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<c:set var="when" value="${empty param.when ? 'now' : param.when}"/>
<label for="when"><fmt:message key="schedule.when"/></label>
<select id="when" name="when">
  <c:forTokens items="now,once,every,weekly" delims="," var="choice"><option value="${choice}" ${when == choice ? 'selected' : ''}><fmt:message key="schedule.when.${choice}"/></option></c:forTokens>
</select>
<div class="when" data-when="once every">
  <label for="first"><fmt:message key="schedule.first"/></label>
  <input id="first" name="first" type="datetime-local" value="${fn:escapeXml(param.first)}" ${empty errors.first ? '' : 'aria-invalid="true"'} aria-describedby="first-help">
  <small id="first-help"><bdi><c:out value="${errors.first}"/></bdi></small>
</div>
<div class="when" data-when="every">
  <label for="everyMinutes"><fmt:message key="schedule.minutes"/></label>
  <input id="everyMinutes" name="everyMinutes" inputmode="numeric" dir="ltr" autocomplete="off" value="${fn:escapeXml(param.everyMinutes)}" ${empty errors.everyMinutes ? '' : 'aria-invalid="true"'} aria-describedby="everyMinutes-help">
  <small id="everyMinutes-help"><bdi><c:out value="${errors.everyMinutes}"/></bdi></small>
</div>
<div class="when" data-when="weekly">
  <fieldset class="choice" ${empty errors.weekdays ? '' : 'aria-invalid="true"'}>
    <legend><fmt:message key="schedule.weekdays"/></legend>
    <c:forEach items="${weekdays}" var="day">
      <c:set var="chosen" value="${false}"/>
      <c:forEach items="${paramValues.weekday}" var="given"><c:if test="${given == day.name()}"><c:set var="chosen" value="${true}"/></c:if></c:forEach>
      <label><input type="checkbox" name="weekday" value="${day}" ${chosen ? 'checked' : ''}> <fmt:message key="schedule.day.${day}"/></label>
    </c:forEach>
    <small class="wrong"><bdi><c:out value="${errors.weekdays}"/></bdi></small>
  </fieldset>
  <label for="time"><fmt:message key="schedule.time"/></label>
  <input id="time" name="time" type="time" value="${fn:escapeXml(param.time)}" ${empty errors.time ? '' : 'aria-invalid="true"'} aria-describedby="time-help">
  <small id="time-help"><bdi><c:out value="${errors.time}"/></bdi></small>
</div>
<div class="when" data-when="every weekly">
  <label for="until"><fmt:message key="schedule.until"/></label>
  <input id="until" name="until" type="datetime-local" value="${fn:escapeXml(param.until)}" ${empty errors.until ? '' : 'aria-invalid="true"'} aria-describedby="until-help">
  <small id="until-help"><bdi><c:out value="${errors.until}"/></bdi></small>
</div>
