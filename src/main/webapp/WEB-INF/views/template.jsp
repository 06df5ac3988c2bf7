<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="template" value="${entry.template()}"/>
<fmt:message key="newTask.map" var="mapLabel"/>
<t:page title="${template.name()}" here="task" script="tasks/template.js">
  <div class="heading">
    <div>
      <p class="faint"><a href="${root}/templates"><fmt:message key="templates.title"/></a></p>
      <h1><bdi><c:out value="${template.name()}"/></bdi></h1>
      <p><t:template-way entry="${entry}"/></p>
    </div>
    <c:if test="${entry.mayChange()}"><div class="choices"><a role="button" class="outline secondary" href="${root}/templates/${template.id()}/edit"><fmt:message key="templates.change"/></a></div></c:if>
  </div>
  <t:errors/>
  <c:forEach items="${entry.gone()}" var="station"><p class="notice bad"><fmt:message key="templates.gone"><fmt:param><bdi><c:out value="${station}"/></bdi></fmt:param></fmt:message></p></c:forEach>
  <div class="columns pick">
    <form class="task" method="post" action="${root}/templates/${template.id()}" novalidate data-template="${fn:escapeXml(template.name())}">
      <t:csrf/>
      <input type="hidden" name="idempotencyKey" value="<c:out value="${idempotencyKey}"/>">
      <c:if test="${empty open}"><p class="faint"><fmt:message key="template.nothing"/></p></c:if>
      <c:forEach items="${open}" var="one" varStatus="at">
        <c:set var="error" value="${errors[one.field()]}"/>
        <c:set var="wrong" value="${empty error ? '' : 'aria-invalid=\"true\"'}"/>
        <c:choose>
          <c:when test="${one.kind() == 'PLACE'}">
            <fieldset class="place" data-place="${fn:escapeXml(one.name())}" ${wrong}>
              <legend><bdi><c:out value="${one.name()}"/></bdi></legend>
              <div>
                <label for="open${at.index}"><fmt:message key="newTask.station"/></label>
                <select id="open${at.index}" name="${fn:escapeXml(one.field())}Station" data-part="station">
                  <option value=""><fmt:message key="newTask.station.none"/></option>
                  <c:forEach items="${floor.stations()}" var="station"><option value="${fn:escapeXml(station.name)}" dir="auto" ${station.name == one.station() ? 'selected' : ''}><c:out value="${station.name}"/></option></c:forEach>
                </select>
              </div>
              <div><label for="open${at.index}X"><fmt:message key="newTask.x"/></label><input id="open${at.index}X" name="${fn:escapeXml(one.field())}X" data-part="x" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(one.x())}" aria-describedby="open${at.index}-help"></div>
              <div><label for="open${at.index}Y"><fmt:message key="newTask.y"/></label><input id="open${at.index}Y" name="${fn:escapeXml(one.field())}Y" data-part="y" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(one.y())}" aria-describedby="open${at.index}-help"></div>
              <small id="open${at.index}-help"><bdi><c:out value="${error}"/></bdi></small>
            </fieldset>
          </c:when>
          <c:when test="${one.kind() == 'ROBOTS'}">
            <fieldset class="choice only" data-robots="${fn:escapeXml(one.name())}" aria-describedby="open${at.index}-help" ${wrong}>
              <legend><bdi><c:out value="${one.name()}"/></bdi></legend>
              <t:robot-choice name="${one.field()}" chosen="${one.robots()}"/>
              <small id="open${at.index}-help" class="wrong"><bdi><c:out value="${error}"/></bdi></small>
            </fieldset>
          </c:when>
          <c:otherwise>
            <label for="open${at.index}"><bdi><c:out value="${one.name()}"/></bdi></label>
            <c:choose>
              <c:when test="${one.kind() == 'MOMENT'}"><input id="open${at.index}" name="${fn:escapeXml(one.field())}" data-moment="${fn:escapeXml(one.name())}" type="datetime-local" value="${fn:escapeXml(one.text())}" ${wrong} aria-describedby="open${at.index}-help"></c:when>
              <c:when test="${one.kind() == 'NUMBER'}"><input id="open${at.index}" name="${fn:escapeXml(one.field())}" data-number="${fn:escapeXml(one.name())}" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(one.text())}" ${wrong} aria-describedby="open${at.index}-help"></c:when>
              <c:otherwise><input id="open${at.index}" name="${fn:escapeXml(one.field())}" data-text="${fn:escapeXml(one.name())}" dir="auto" autocomplete="off" value="${fn:escapeXml(one.text())}" ${wrong} aria-describedby="open${at.index}-help"></c:otherwise>
            </c:choose>
            <small id="open${at.index}-help"><c:choose><c:when test="${not empty error}"><bdi><c:out value="${error}"/></bdi></c:when><c:otherwise><fmt:message key="template.field.${one.what()}"><fmt:param value="${one.stop()}"/></fmt:message></c:otherwise></c:choose></small>
          </c:otherwise>
        </c:choose>
      </c:forEach>
      <input type="hidden" id="zone" name="zone" value="UTC">
      <t:when/>
      <div class="choices"><button><fmt:message key="newTask.submit"/></button></div>
    </form>
    <div class="picker">
      <fieldset class="choice" hidden>
        <legend><fmt:message key="newTask.setOnMap"/></legend>
        <c:forEach items="${open}" var="one"><c:if test="${one.kind() == 'PLACE'}"><label><input type="radio" name="picks" value="${fn:escapeXml(one.name())}"> <bdi><c:out value="${one.name()}"/></bdi></label></c:if></c:forEach>
      </fieldset>
      <canvas id="map" tabindex="0" role="img" aria-label="${mapLabel}" data-floor="${fn:escapeXml(template.floor())}"></canvas>
      <output id="preview" class="preview" dir="auto" hidden></output>
    </div>
  </div>
  <t:texts keys="common.comma map.speedLimit map.failed newTask.preview.chosen newTask.preview.needs newTask.preview.waits newTask.preview.metres newTask.preview.driven"/>
</t:page>
