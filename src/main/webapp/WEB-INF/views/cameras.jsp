<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="cameras.title" var="title"/>
<t:page title="${title}" here="cameras" script="cameras/cameras.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="cameras.intro"/>${" "}<t:help topic="cameras"/></p>
    </div>
  </div>
  <c:if test="${param.done == 'added' or param.done == 'changed' or param.done == 'removed'}"><p class="notice good" role="status"><fmt:message key="cameras.done.${param.done}"/></p></c:if>
  <c:if test="${empty cameras}"><p class="notice"><fmt:message key="cameras.empty"/></p></c:if>
  <div class="cameras">
    <c:forEach items="${cameras}" var="camera">
      <article class="card">
        <t:camera camera="${camera}"/>
        <p class="faint"><c:choose>
          <c:when test="${not empty camera.robot()}"><c:url value="/robots/${camera.robot()}/control" var="place"/><fmt:message key="cameras.ofRobot"/>${" "}<a href="<c:out value="${place}"/>"><bdi><c:out value="${camera.robot()}"/></bdi></a></c:when>
          <c:otherwise><c:url value="/map" var="place"><c:param name="floor" value="${camera.floor()}"/></c:url><fmt:message key="cameras.ofFloor"/>${" "}<a href="<c:out value="${place}"/>"><bdi><c:out value="${camera.floor()}"/></bdi></a></c:otherwise>
        </c:choose><c:if test="${caller.mayManage()}"><br><bdi dir="ltr" class="address"><c:out value="${camera.url().host}"/></bdi></c:if></p>
        <c:if test="${caller.mayManage()}">
          <p><a href="${root}/cameras?edit=${camera.id()}#camera"><fmt:message key="cameras.change"/></a></p>
          <details class="or">
            <summary role="button" class="outline secondary"><fmt:message key="cameras.remove"/></summary>
            <form method="post" action="${root}/cameras/${camera.id()}/delete">
              <t:csrf/>
              <p><fmt:message key="cameras.remove.sure"/></p>
              <button class="danger"><fmt:message key="cameras.remove"/></button>
            </form>
          </details>
        </c:if>
      </article>
    </c:forEach>
  </div>
  <c:if test="${caller.mayManage()}">
    <article class="card" id="camera">
      <h2><fmt:message key="${empty edited ? 'cameras.add' : 'cameras.edit'}"><fmt:param><bdi><c:out value="${edited.name()}"/></bdi></fmt:param></fmt:message></h2>
      <t:errors/>
      <form method="post" action="${root}/cameras${empty edited ? '' : '/'}${edited.id()}${empty edited ? '' : '/change'}" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="name" label="cameras.name" latin="true" value="${edited.name()}"/></div>
          <div><t:field name="url" label="cameras.url" hint="cameras.url.hint" latin="true" value="${edited.url()}"/></div>
        </div>
        <div class="grid">
          <c:forTokens items="robot,floor" delims="," var="place">
            <div>
              <label for="${place}"><fmt:message key="cameras.${place}"/></label>
              <select id="${place}" name="${place}" ${empty errors[place] ? '' : 'aria-invalid="true" aria-describedby="'.concat(place).concat('-help"')}>
                <option value=""><fmt:message key="common.none"/></option>
                <c:choose>
                  <c:when test="${place == 'robot'}"><c:forEach items="${robots}" var="choice"><option dir="auto" ${choice == (param.robot == null ? edited.robot() : param.robot) ? 'selected' : ''}><c:out value="${choice}"/></option></c:forEach></c:when>
                  <c:otherwise><c:forEach items="${floors}" var="choice"><option dir="auto" value="<c:out value="${choice.name()}"/>" ${choice.name() == (param.floor == null ? edited.floor() : param.floor) ? 'selected' : ''}><c:out value="${choice.name()}"/></option></c:forEach></c:otherwise>
                </c:choose>
              </select>
              <c:if test="${not empty errors[place]}"><small id="${place}-help" class="wrong"><bdi><c:out value="${errors[place]}"/></bdi></small></c:if>
            </div>
          </c:forTokens>
        </div>
        <button><fmt:message key="${empty edited ? 'cameras.add' : 'notices.save'}"/></button>
        <c:if test="${not empty edited}"><a href="${root}/cameras"><fmt:message key="network.edit.leave"/></a></c:if>
      </form>
    </article>
  </c:if>
  <t:texts keys="camera.failed"/>
</t:page>
