<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="newTask.title" var="title"/>
<fmt:message key="newTask.map" var="mapLabel"/>
<t:page title="${title}" here="task" script="pick.js">
  <h1>${title}</h1>
  <p class="faint"><fmt:message key="newTask.intro"/></p>
  <t:errors/>
  <div class="columns pick">
    <form method="post" action="${root}/tasks/new" novalidate>
      <t:csrf/>
      <t:field name="name" label="newTask.name" hint="newTask.name.hint" focus="true"/>
      <t:field name="load" label="newTask.load" inputmode="decimal"/>
      <c:choose>
        <c:when test="${fn:length(floors) > 1}">
          <label for="floor"><fmt:message key="newTask.floor"/></label>
          <select id="floor" name="floor">
            <c:forEach items="${floors}" var="f"><option value="${fn:escapeXml(f.name)}" ${f.name == floor.name ? 'selected' : ''}><c:out value="${f.name}"/></option></c:forEach>
          </select>
        </c:when>
        <c:otherwise><input type="hidden" id="floor" name="floor" value="${fn:escapeXml(floor.name)}"></c:otherwise>
      </c:choose>
      <c:forTokens items="start,goal" delims="," var="end">
        <c:set var="stationField" value="${end}Station"/>
        <fieldset class="place" ${not empty errors[end] ? 'aria-invalid="true"' : ''}>
          <legend><fmt:message key="newTask.${end}"/></legend>
          <div>
            <label for="${stationField}"><fmt:message key="newTask.station"/></label>
            <select id="${stationField}" name="${stationField}">
              <option value=""><fmt:message key="newTask.station.none"/></option>
              <c:forEach items="${floor.stations}" var="station"><option value="${fn:escapeXml(station.name)}" ${station.name == param[stationField] ? 'selected' : ''}><c:out value="${station.name}"/></option></c:forEach>
            </select>
          </div>
          <div><label for="${end}X"><fmt:message key="newTask.x"/></label><input id="${end}X" name="${end}X" inputmode="decimal" autocomplete="off" value="${fn:escapeXml(param[end += 'X'])}" aria-describedby="${end}-help"></div>
          <div><label for="${end}Y"><fmt:message key="newTask.y"/></label><input id="${end}Y" name="${end}Y" inputmode="decimal" autocomplete="off" value="${fn:escapeXml(param[end += 'Y'])}" aria-describedby="${end}-help"></div>
          <small id="${end}-help"><c:out value="${errors[end]}"/></small>
        </fieldset>
      </c:forTokens>
      <label for="deadline"><fmt:message key="newTask.deadline"/></label>
      <input id="deadline" name="deadline" type="datetime-local" value="${fn:escapeXml(param.deadline)}" ${empty errors.deadline ? '' : 'aria-invalid="true"'} aria-describedby="deadline-help">
      <small id="deadline-help"><c:choose><c:when test="${not empty errors.deadline}"><c:out value="${errors.deadline}"/></c:when><c:otherwise><fmt:message key="newTask.deadline.zone"/>${" "}<span id="zone-name"><fmt:message key="newTask.deadline.utc"/></span></c:otherwise></c:choose></small>
      <input type="hidden" id="zone" name="zone" value="UTC">
      <button><fmt:message key="newTask.submit"/></button>
    </form>
    <div class="picker">
      <fieldset class="choice">
        <legend><fmt:message key="newTask.picks"/></legend>
        <label><input type="radio" name="picks" value="start" checked> <fmt:message key="newTask.start"/></label>
        <label><input type="radio" name="picks" value="goal"> <fmt:message key="newTask.goal"/></label>
      </fieldset>
      <canvas id="map" tabindex="0" role="img" aria-label="${mapLabel}" data-floor="${fn:escapeXml(floor.name)}"></canvas>
      <small><fmt:message key="newTask.map.hint"/></small>
    </div>
  </div>
  <t:texts keys="newTask.start newTask.goal map.failed"/>
</t:page>
