<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="edits" value="${not empty task}"/>
<fmt:message key="${edits ? 'task.edit.title' : 'newTask.title'}" var="title"><fmt:param value="${task.task.id}"/></fmt:message>
<fmt:message key="newTask.map" var="mapLabel"/>
<t:page title="${title}" here="task" script="tasks/new-task.js">
  <h1>${title}</h1>
  <p class="faint"><fmt:message key="${edits ? 'task.edit.intro' : 'newTask.intro'}"/>${" "}<t:help topic="tasks" section="orders-of-several-tasks"/></p>
  <t:errors/>
  <c:if test="${not edits and not empty templates}">
    <nav class="choices templates" aria-label="<fmt:message key="newTask.templates"/>">
      <span class="faint"><fmt:message key="newTask.templates"/></span>
      <c:forEach items="${templates}" var="template" end="7"><a href="${root}/templates/${template.id}"><bdi><c:out value="${template.name}"/></bdi></a></c:forEach>
      <c:if test="${templates.size() > 8}"><a href="${root}/templates"><fmt:message key="newTask.templates.all"/></a></c:if>
    </nav>
  </c:if>
  <div class="columns pick">
    <form class="task" method="post" action="${root}/tasks/${edits ? task.task.id += '/edit' : 'new'}" novalidate>
      <t:csrf/>
      <c:choose>
        <c:when test="${edits}"><t:version/></c:when>
        <c:otherwise><input type="hidden" name="idempotencyKey" value="<c:out value="${idempotencyKey}"/>"></c:otherwise>
      </c:choose>
      <t:field name="name" label="newTask.name" hint="newTask.name.hint" focus="true"/>
      <c:if test="${not edits}">
        <label for="kind"><fmt:message key="newTask.kind"/></label>
        <select id="kind" name="kind" ${empty errors.kind ? '' : 'aria-invalid="true"'}>
          <c:forTokens items="transport,drive" delims="," var="choice"><option value="${choice}" ${choice == param.kind ? 'selected' : ''}><fmt:message key="newTask.kind.${choice}"/></option></c:forTokens>
        </select>
        <c:if test="${not empty errors.kind}"><small class="wrong"><bdi><c:out value="${errors.kind}"/></bdi></small></c:if>
      </c:if>
      <c:choose>
        <c:when test="${edits}"><t:field name="load" label="newTask.load" inputmode="decimal"/></c:when>
        <c:otherwise>
          <div class="grid" data-for="transport">
            <div><t:field name="load" label="newTask.load" inputmode="decimal"/></div>
            <div><t:field name="pieces" label="newTask.pieces" hint="newTask.pieces.hint" inputmode="numeric" optional="true" value="1"/></div>
          </div>
        </c:otherwise>
      </c:choose>
      <c:choose>
        <c:when test="${fn:length(floors) > 1}">
          <label for="floor"><fmt:message key="newTask.floor"/></label>
          <select id="floor" name="floor">
            <c:forEach items="${floors}" var="f"><option value="${fn:escapeXml(f.name())}" dir="auto" ${f.name() == floor.name() ? 'selected' : ''}><c:out value="${f.name()}"/></option></c:forEach>
          </select>
        </c:when>
        <c:otherwise><input type="hidden" id="floor" name="floor" value="${fn:escapeXml(floor.name())}"></c:otherwise>
      </c:choose>
      <c:forTokens items="start,goal" delims="," var="end">
        <c:set var="stationField" value="${end}Station"/>
        <fieldset class="place" ${end == 'start' ? 'data-for="transport"' : ''} ${not empty errors[end] ? 'aria-invalid="true"' : ''}>
          <legend><fmt:message key="newTask.${end}"/></legend>
          <div>
            <label for="${stationField}"><fmt:message key="newTask.station"/></label>
            <select id="${stationField}" name="${stationField}">
              <option value=""><fmt:message key="newTask.station.none"/></option>
              <c:forEach items="${floor.stations()}" var="station"><option value="${fn:escapeXml(station.name)}" dir="auto" ${station.name == param[stationField] ? 'selected' : ''}><c:out value="${station.name}"/></option></c:forEach>
              <c:if test="${end == 'goal' and not edits}"><t:charger-options chosen="${param.goalStation}" kind="drive"/></c:if>
            </select>
          </div>
          <div><label for="${end}X"><fmt:message key="newTask.x"/></label><input id="${end}X" name="${end}X" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param[end += 'X'])}" aria-describedby="${end}-help"></div>
          <div><label for="${end}Y"><fmt:message key="newTask.y"/></label><input id="${end}Y" name="${end}Y" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param[end += 'Y'])}" aria-describedby="${end}-help"></div>
          <small id="${end}-help"><bdi><c:out value="${errors[end]}"/></bdi></small>
        </fieldset>
      </c:forTokens>
      <c:set var="usesArm" value="${not empty param.pickX or not empty param.pickY or not empty param.placeX or not empty param.placeY or not empty errors.arm or not empty errors['arm.pick'] or not empty errors['arm.place']}"/>
      <c:if test="${hasArms or usesArm}">
        <details class="stops" data-for="transport" ${usesArm ? 'open' : ''}>
          <summary><fmt:message key="newTask.arm"/></summary>
          <p class="faint"><c:choose><c:when test="${not empty errors.arm}"><bdi class="wrong"><c:out value="${errors.arm}"/></bdi></c:when><c:otherwise><fmt:message key="newTask.arm.hint"/></c:otherwise></c:choose></p>
          <c:forTokens items="pick,place" delims="," var="end">
            <c:set var="error" value="${errors['arm.' += end]}"/>
            <fieldset class="place" ${not empty error ? 'aria-invalid="true"' : ''}>
              <legend><fmt:message key="newTask.arm.${end}"/></legend>
              <div><label for="${end}X"><fmt:message key="newTask.x"/></label><input id="${end}X" name="${end}X" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param[end += 'X'])}" aria-describedby="${end}-help"></div>
              <div><label for="${end}Y"><fmt:message key="newTask.y"/></label><input id="${end}Y" name="${end}Y" inputmode="decimal" dir="ltr" autocomplete="off" value="${fn:escapeXml(param[end += 'Y'])}" aria-describedby="${end}-help"></div>
              <small id="${end}-help"><bdi><c:out value="${error}"/></bdi></small>
            </fieldset>
          </c:forTokens>
        </details>
      </c:if>
      <c:if test="${not edits}">
        <c:set var="chosenStops" value=""/>
        <c:forEach items="${paramValues.stopStation}" var="given"><c:set var="chosenStops" value="${chosenStops}${given}"/></c:forEach>
        <c:set var="chosenStops" value="${chosenStops}${param.startWait}${param.goalWait}"/>
        <details class="stops" ${not empty chosenStops or not empty errors.stop ? 'open' : ''}>
          <summary><fmt:message key="newTask.stops"/></summary>
          <p class="faint" id="stop-help"><c:choose><c:when test="${not empty errors.stop}"><bdi class="wrong"><c:out value="${errors.stop}"/></bdi></c:when><c:otherwise><span data-for="transport"><fmt:message key="newTask.stops.hint"/></span><span data-for="drive"><fmt:message key="newTask.stops.drive.hint"/></span></c:otherwise></c:choose></p>
          <div class="grid">
            <c:forTokens items="start,goal" delims="," var="end">
              <c:set var="waitField" value="${end}Wait"/>
              <fmt:message key="newTask.${end}" var="endLabel"/>
              <div ${end == 'start' ? 'data-for="transport"' : ''}><label><fmt:message key="newTask.wait.at"><fmt:param value="${endLabel}"/></fmt:message><fmt:message key="newTask.wait.at" var="label"><fmt:param value="${endLabel}"/></fmt:message><t:wait-choice name="${waitField}" label="${label}" chosen="${param[waitField]}" charges="${end == 'goal' and not empty floor.charging()}"/></label></div>
            </c:forTokens>
          </div>
          <c:forEach begin="0" end="${fn:length(paramValues.stopStation) > 4 ? fn:length(paramValues.stopStation) - 1 : 3}" var="at">
            <fmt:message key="newTask.stop" var="label"><fmt:param value="${at + 3}"/></fmt:message>
            <select name="stopStation" aria-label="${label}" aria-describedby="stop-help" ${not empty errors.stop ? 'aria-invalid="true"' : ''}>
              <option value="">${label}: <fmt:message key="newTask.station.none"/></option>
              <c:forEach items="${floor.stations()}" var="station"><option value="${fn:escapeXml(station.name)}" dir="auto" ${station.name == paramValues.stopStation[at] ? 'selected' : ''}><c:out value="${station.name}"/></option></c:forEach>
              <c:if test="${paramValues.stopStation[at].matches('-?[0-9.]+ -?[0-9.]+')}"><option value="${fn:escapeXml(paramValues.stopStation[at])}" selected>(${fn:escapeXml(fn:replace(paramValues.stopStation[at], ' ', ', '))})</option></c:if>
              <t:charger-options chosen="${paramValues.stopStation[at]}"/>
            </select>
            <fmt:message key="newTask.wait.at" var="waitLabel"><fmt:param value="${label}"/></fmt:message>
            <t:wait-choice name="stopWait" label="${waitLabel}" chosen="${paramValues.stopWait[at]}" charges="${not empty floor.charging()}"/>
          </c:forEach>
          <div data-for="transport">
            <label for="carriedBy"><fmt:message key="newTask.carriedBy"/></label>
            <select id="carriedBy" name="carriedBy">
              <c:forTokens items="legs,one" delims="," var="choice"><option value="${choice}" ${choice == param.carriedBy ? 'selected' : ''}><fmt:message key="newTask.carriedBy.${choice}"/></option></c:forTokens>
            </select>
          </div>
        </details>
      </c:if>
      <c:if test="${not empty robots or not empty chosenRobots}">
        <details class="only-robots" ${not empty chosenRobots or not empty errors.onlyRobots ? 'open' : ''}>
          <summary><fmt:message key="newTask.onlyRobots"/></summary>
          <fieldset class="choice only" aria-describedby="onlyRobots-help" ${empty errors.onlyRobots ? '' : 'aria-invalid="true"'}>
            <legend class="faint"><fmt:message key="newTask.onlyRobots.legend"/></legend>
            <t:robot-choice name="onlyRobots" chosen="${chosenRobots}"/>
          </fieldset>
          <small id="onlyRobots-help"><c:choose><c:when test="${not empty errors.onlyRobots}"><bdi class="wrong"><c:out value="${errors.onlyRobots}"/></bdi></c:when><c:otherwise><fmt:message key="newTask.onlyRobots.hint"/></c:otherwise></c:choose></small>
        </details>
      </c:if>
      <div class="grid">
        <div>
          <label for="priority"><fmt:message key="newTask.priority"/></label>
          <c:set var="priority" value="${empty param.priority ? '0' : param.priority}"/>
          <select id="priority" name="priority">
            <c:if test="${edits and priority != '10' and priority != '0' and priority != '-10'}"><option value="${fn:escapeXml(priority)}" selected>${fn:escapeXml(priority)}</option></c:if>
            <c:forTokens items="10,0,-10" delims="," var="level"><option value="${level}" ${level == priority ? 'selected' : ''}><fmt:message key="newTask.priority.${level}"/></option></c:forTokens>
          </select>
        </div>
        <fieldset class="size" data-for="transport" ${not empty errors['size.length'] or not empty errors['size.width'] or not empty errors.size ? 'aria-invalid="true"' : ''}>
          <legend><fmt:message key="newTask.size"/></legend>
          <input id="length" name="length" inputmode="decimal" dir="ltr" autocomplete="off" aria-label="<fmt:message key="newTask.size.length"/>" value="${fn:escapeXml(param.length)}" aria-describedby="size-help">
          <span aria-hidden="true">×</span>
          <input id="width" name="width" inputmode="decimal" dir="ltr" autocomplete="off" aria-label="<fmt:message key="newTask.size.width"/>" value="${fn:escapeXml(param.width)}" aria-describedby="size-help">
          <small id="size-help"><bdi><c:out value="${errors.size}${empty errors.size ? errors['size.length'] : ''}${empty errors.size and empty errors['size.length'] ? errors['size.width'] : ''}"/></bdi></small>
        </fieldset>
      </div>
      <label for="deadline"><fmt:message key="newTask.deadline"/></label>
      <input id="deadline" name="deadline" type="datetime-local" value="${fn:escapeXml(param.deadline)}" ${empty deadlineInUtc ? '' : 'data-in-utc'} ${empty errors.deadline ? '' : 'aria-invalid="true"'} aria-describedby="deadline-help">
      <small id="deadline-help"><c:choose><c:when test="${not empty errors.deadline}"><bdi><c:out value="${errors.deadline}"/></bdi></c:when><c:otherwise><fmt:message key="newTask.deadline.zone"/>${" "}<bdi id="zone-name"><fmt:message key="newTask.deadline.utc"/></bdi></c:otherwise></c:choose></small>
      <input type="hidden" id="zone" name="zone" value="UTC">
      <c:if test="${not edits}"><t:when/></c:if>
      <div class="choices">
        <button><fmt:message key="${edits ? 'task.edit.submit' : 'newTask.submit'}"/></button>
        <c:if test="${not edits}"><button class="outline secondary" formaction="${root}/templates/new"><fmt:message key="newTask.template.save"/></button></c:if>
        <c:if test="${edits}"><a role="button" class="outline secondary" href="${root}/tasks/${task.task.id}"><fmt:message key="common.cancel"/></a></c:if>
      </div>
    </form>
    <div class="picker">
      <fieldset class="choice">
        <legend><fmt:message key="newTask.setOnMap"/></legend>
        <label data-for="transport"><input type="radio" name="picks" value="start" checked> <fmt:message key="newTask.start"/></label>
        <label><input type="radio" name="picks" value="goal"> <fmt:message key="newTask.goal"/></label>
      </fieldset>
      <canvas id="map" tabindex="0" role="img" aria-label="${mapLabel}" data-floor="${fn:escapeXml(floor.name())}"></canvas>
      <small><fmt:message key="newTask.map.hint"/></small>
      <output id="preview" class="preview" dir="auto" for="load startStation goalStation" hidden></output>
    </div>
  </div>
  <t:texts keys="common.comma map.speedLimit newTask.start newTask.goal map.failed newTask.preview.chosen newTask.preview.needs newTask.preview.waits newTask.preview.metres newTask.preview.driven"/>
</t:page>
